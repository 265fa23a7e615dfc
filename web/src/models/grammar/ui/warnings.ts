/**
 * Warnings about a plant that lacks parts of the request, with reasons: shown beside its picture and below its text.
 */
import { blankComments } from "../../../grammar_editor/comments";
import { withThousands } from "../../../ui/thousands";
import type { GrammarPlant } from "../grammar_plant";
import type { GrammarSpecimen } from "../specimen";
import { fetchedText, usesAreas } from "../texts";

const BARE = /^Nothing grows in area (\d+):/;
/** Notes of the core that are shown as warnings; others are shown with the numbers, or at a place in the text. */
const CUT = /^What grew so far is shown/;
const REPORTED = /^The grammar (?:draws nothing|has no #define)/;

/**
 * Returns the warnings, a line each.
 * @param specimen that the plant has grown from
 */
export function warningsOf({ notes, counts }: GrammarPlant, specimen: GrammarSpecimen): readonly string[] {
	const text = fetchedText(specimen) ?? "";
	const bare = notes.filter((note) => BARE.test(note));
	const cut = notes.filter((note) => CUT.test(note)).map(withThousands);
	return [
		...(cut.length > 0 ? [[...cut, ...stepsOf(counts.steps, specimen, text)].join(" ")] : []),
		...notes.filter((note) => REPORTED.test(note)),
		...reasonsOf(bare).map(inOne),
		...(usesAreas(text) && !specimen.areas?.length
			? ["There is no growth area, so the branches have no room. Add one under “Growth areas”, or undo."]
			: []),
	];
}

/** Returns the growth areas in which nothing grows, counted from 0. */
export function bareAreas({ notes }: Pick<GrammarPlant, "notes">): ReadonlySet<number> {
	return new Set(notes.flatMap((note) => Number(BARE.exec(note)?.[1] ?? 0) - 1).filter((area) => area >= 0));
}

/** Groups notes about empty areas by their reason. */
function reasonsOf(notes: readonly string[]): string[][] {
	const together = new Map<string, string[]>();
	for (const note of notes) {
		const reason = note.replace(BARE, ":");
		together.set(reason, [...(together.get(reason) ?? []), note]);
	}
	return [...together.values()];
}

/** Joins notes of one reason, which differ by the area only. */
function inOne(notes: readonly string[]): string {
	const numbers = notes.map((note) => BARE.exec(note)?.[1]);
	if (numbers.length < 2) return notes[0];
	const areas = `areas ${numbers.slice(0, -1).join(", ")} and ${numbers.at(-1)}`;
	return notes[0].replace(BARE, `Nothing grows in ${areas}:`);
}

/** Returns how many steps were done, if fewer than requested. */
function stepsOf(done: number, { steps, constants }: GrammarSpecimen, text: string): string[] {
	const requested = steps ?? lengthIn(text, constants);
	return requested !== undefined && done < requested ? [`These are ${done} of ${requested} steps.`] : [];
}

/** Returns the derivation length, if it is a number or the name of one; the core evaluates expressions. */
function lengthIn(text: string, constants: GrammarSpecimen["constants"]): number | undefined {
	const bare = blankComments(text);
	const [, length = ""] = /^[ \t]*derivation[ \t]+length[ \t]*:[ \t]*([\p{L}\w]+)[ \t]*$/imu.exec(bare) ?? [];
	const numbers = bare.matchAll(/^[ \t]*#define[ \t]+([\p{L}\p{N}_]+)[ \t]+(\d+)[ \t]*$/gmu);
	const defined = [...numbers].find(([, name]) => name === length)?.[2];
	const given = Object.hasOwn(constants, length) ? constants[length] : undefined;
	const requested = /^\d+$/.test(length) ? length : (given ?? defined);
	return requested === undefined ? undefined : Number(requested);
}
