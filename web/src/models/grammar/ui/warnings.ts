/**
 * Warnings about a plant that lacks parts of the request, with reasons: shown beside its picture and below its text.
 */

import { blankComments } from "../../../grammar_editor/comments";
import { formatList } from "../../../locale/format";
import type { Message } from "../../../locale/texts";
import type { GrammarPlant } from "../grammar_plant";
import { text as message } from "../messages.generated";
import type { GrammarSpecimen } from "../specimen";
import { fetchedText, usesAreas } from "../texts";

/** Codes of notes that are shown as warnings; others are shown with the numbers, or at a place in the text. */
const NOT_REACHED = "core.grammar.area_not_reached";
const IN_AREA = "core.grammar.area_in_area";
const CUT = "core.grammar.cut_short";
const REPORTED = ["core.lsystem_plant.nothing_drawn", "core.lsystem.remark_unknown_parameter"];

/**
 * Returns the warnings, a line each.
 * @param specimen that the plant has grown from
 */
export function warningsOf(
	{ noteMessages = [], counts }: Pick<GrammarPlant, "noteMessages" | "counts">,
	specimen: GrammarSpecimen,
): readonly string[] {
	const text = fetchedText(specimen) ?? "";
	const cutShort = noteMessages.filter(({ code }) => code === CUT).map((note) => note.text);
	return [
		...(cutShort.length > 0 ? [[...cutShort, ...stoppedEarly(counts.steps, specimen, text)].join(" ")] : []),
		...noteMessages.filter(({ code }) => REPORTED.includes(code)).map((note) => note.text),
		...joinNotReached(noteMessages.filter(({ code }) => code === NOT_REACHED)),
		...noteMessages.filter(({ code }) => code === IN_AREA).map((note) => note.text),
		...(usesAreas(text) && !specimen.areas?.length ? [message("no_area")] : []),
	];
}

/** Returns the growth areas that stay empty, counted from 0. */
export function bareAreas({ noteMessages = [] }: Pick<GrammarPlant, "noteMessages">): ReadonlySet<number> {
	const bare = noteMessages.filter(({ code }) => code === NOT_REACHED || code === IN_AREA);
	return new Set(bare.map(({ args: { area } }) => Number(area) - 1));
}

/** Joins the notes on areas that the main branch does not reach. */
function joinNotReached(notes: readonly Message[]): string[] {
	if (notes.length < 2) return notes.map(({ text }) => text);
	return [message("areas_not_reached", { areas: formatList(notes.map(({ args }) => String(args.area))) })];
}

/** Returns a warning with the number of steps done, if fewer than requested; else an empty list. */
function stoppedEarly(done: number, { steps, constants }: GrammarSpecimen, text: string): string[] {
	const requested = steps ?? derivationLength(text, constants);
	return requested !== undefined && done < requested ? [message("stopped_early", { done, steps: requested })] : [];
}

/**
 * Returns the derivation length of a text, if it is a number or the name of one; undefined for expressions, which the
 * core evaluates.
 */
function derivationLength(text: string, constants: GrammarSpecimen["constants"]): number | undefined {
	const code = blankComments(text);
	const [, length = ""] = /^[ \t]*derivation[ \t]+length[ \t]*:[ \t]*([\p{L}\w]+)[ \t]*$/imu.exec(code) ?? [];
	const numbers = code.matchAll(/^[ \t]*#define[ \t]+([\p{L}\p{N}_]+)[ \t]+(\d+)[ \t]*$/gmu);
	const defined = [...numbers].find(([, name]) => name === length)?.[2];
	const constant = Object.hasOwn(constants, length) ? constants[length] : undefined;
	const requested = /^\d+$/.test(length) ? length : (constant ?? defined);
	return requested === undefined ? undefined : Number(requested);
}
