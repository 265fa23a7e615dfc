/** Writes choices and drags into a flower's text: merges edits made by hand, and reports lost lines. */

import { type GrammarSource, textOf as grownText, withText } from "../../../../grammar_editor/source";
import type { EditorContext } from "../../../../ui/editor_context";
import { sameDocument } from "../../../../ui/same_document";
import { choose } from "../../design/choose";
import { type Description, lineOf } from "../../design/description";
import { type Design, designOf, textOf } from "../../design/design";
import type { FlowerPlant } from "../../flower_plant";
import { text as message } from "../../messages.generated";
import type { FlowerSpecimen } from "../../specimen";
import { fetchedText } from "../../texts";
import { source } from "../text";

export type FlowerContext = EditorContext<FlowerSpecimen, FlowerPlant>;

const GESTURE = "design";

let cachedDesign: { readonly text: string; readonly design: Design | undefined } | undefined;

const grammar = source as unknown as GrammarSource;

/** Returns the text of a flower with the values of its sliders written in; undefined if it has not been fetched. */
export const valuedText = (specimen: FlowerSpecimen): string | undefined =>
	fetchedText(specimen) === undefined ? undefined : grownText(grammar, specimen, () => {});

/**
 * Returns the change that sets a flower's text. It also drops slider values, which would override the values that a
 * choice writes.
 */
export const textChange = (specimen: FlowerSpecimen, text: string) => withText(grammar, specimen, text);

/** Returns the design in a flower's text; undefined if it has no descriptions or has not been fetched. */
export function designIn(specimen: FlowerSpecimen): Design | undefined {
	const text = valuedText(specimen);
	if (text === undefined) return undefined;
	if (cachedDesign?.text !== text) cachedDesign = { text, design: designOf(text) };
	return cachedDesign.design;
}

/** Returns the descriptions of a design's organs. */
export const descriptionsIn = ({ sections }: Design): readonly Description[] =>
	sections.map(({ description }) => description);

/** Result of writing descriptions into a text. */
interface MergedText {
	readonly text: string;
	readonly retained: string;
	readonly lost: readonly string[];
}

/** Writes changed descriptions into a design; its text stays the same where no description differs. */
function mergeDescriptions(design: Design, descriptions: readonly Description[]): MergedText {
	let [merged, retained]: readonly [Design, Design] = [design, design];
	let lost: readonly string[] = [];
	for (const [i, description] of descriptions.entries()) {
		if (lineOf(description) === lineOf(design.sections[i].description)) continue;
		const chosen = choose(merged, description);
		lost = [...lost, ...chosen.lost];
		merged = designOf(chosen.text) ?? merged;
		retained = designOf(choose(retained, description).retained) ?? retained;
	}
	return { text: textOf(merged), retained: textOf(retained), lost };
}

/**
 * Drafts of one gesture: each is merged with the text from before the gesture, so that a cancelled gesture leaves no
 * change.
 */
export class Drafts {
	#before: Design | undefined;
	#last: MergedText | undefined;

	/** Applies a draft while the gesture goes on. Drafts of the same `run`, the key that is held down, are one undo step. */
	edit(context: FlowerContext, descriptions: readonly Description[], run?: string): void {
		// The text may have changed otherwise: by undo, the editor, or another plant.
		const { specimen } = context.state;
		if (!this.#last || valuedText(specimen) !== this.#last.text) this.#before = designIn(specimen);
		if (!this.#before) return;
		this.#last = mergeDescriptions(this.#before, descriptions);
		context.edit({ ...textChange(specimen, this.#last.text), run }, GESTURE);
	}

	/** Ends the gesture as one undo step and reports lost lines. */
	settle(context: FlowerContext): void {
		context.settle(GESTURE);
		const lastDraft = this.#last;
		this.#before = undefined;
		this.#last = undefined;
		if (lastDraft && lastDraft.lost.length > 0 && valuedText(context.state.specimen) === lastDraft.text)
			reportLostLines(context, lastDraft);
	}

	/** Applies a single choice. */
	set(context: FlowerContext, description: Description): void {
		const design = designIn(context.state.specimen);
		if (!design) return;
		const descriptions = descriptionsIn(design).map((each) => (each.organ === description.organ ? description : each));
		this.edit(context, descriptions);
		this.settle(context);
	}
}

const MAX_LISTED = 4;

/** Notifies of lines that a choice has replaced, with a button that restores them unless the text has changed since. */
function reportLostLines(context: FlowerContext, { text, lost, retained }: MergedText): void {
	const isSameDocument = sameDocument(context);
	const restore = () => {
		if (isSameDocument() && valuedText(context.state.specimen) === text)
			context.set(textChange(context.state.specimen, retained));
		else context.notify(message("lines_not_restored"), [message("text_changed")], { topic: GESTURE });
	};
	const more = lost.length > MAX_LISTED ? [message("more_lines", { count: lost.length - MAX_LISTED })] : [];
	context.notify(
		message("lines_replaced"),
		[...lost.slice(0, MAX_LISTED).map((line) => line.trim()), ...more, message("undo_reverts")],
		{ topic: GESTURE, act: { label: message("restore_lines"), run: restore } },
	);
}
