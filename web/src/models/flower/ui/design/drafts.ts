/** Choices and drags written into a flower's text: what was edited by hand is merged in, and what cannot be retained is told. */

import { type GrammarSource, textOf as grownText, withText } from "../../../../grammar_editor/source";
import type { EditorContext } from "../../../../ui/editor_context";
import { sameDocument } from "../../../../ui/same_document";
import { choose } from "../../design/choose";
import { type Description, lineOf } from "../../design/description";
import { type Design, designOf, textOf } from "../../design/design";
import type { FlowerPlant } from "../../flower_plant";
import type { FlowerSpecimen } from "../../specimen";
import { fetchedText } from "../../texts";
import { source } from "../text";

export type FlowerContext = EditorContext<FlowerSpecimen, FlowerPlant>;

const GESTURE = "design";

let last: { readonly text: string; readonly design: Design | undefined } | undefined;

const grammar = source as unknown as GrammarSource;

/** The text that a flower grows by, with the values that stand beside it, as by sliders, in it; undefined where it has yet to be fetched. */
export const valuedText = (specimen: FlowerSpecimen): string | undefined =>
	fetchedText(specimen) === undefined ? undefined : grownText(grammar, specimen, () => {});

/** The change that makes a text a flower's: values beside the one before would else hold against what a choice says there. */
export const textChange = (specimen: FlowerSpecimen, text: string) => withText(grammar, specimen, text);

/** What a flower's text describes; undefined where it has no descriptions, or has yet to be fetched. */
export function designIn(specimen: FlowerSpecimen): Design | undefined {
	const text = valuedText(specimen);
	if (text === undefined) return undefined;
	if (last?.text !== text) last = { text, design: designOf(text) };
	return last.design;
}

/** The organs as a flower's text describes them. */
export const descriptionsIn = ({ sections }: Design): readonly Description[] =>
	sections.map(({ description }) => description);

interface Written {
	readonly text: string;
	readonly retained: string;
	readonly lost: readonly string[];
}

/** A design with its organs described so. Where nothing is described otherwise its text is what it was. */
function written(design: Design, descriptions: readonly Description[]): Written {
	let [mine, retained]: readonly [Design, Design] = [design, design];
	let lost: readonly string[] = [];
	for (const [i, description] of descriptions.entries()) {
		if (lineOf(description) === lineOf(design.sections[i].description)) continue;
		const chosen = choose(mine, description);
		lost = [...lost, ...chosen.lost];
		mine = designOf(chosen.text) ?? mine;
		retained = designOf(choose(retained, description).retained) ?? retained;
	}
	return { text: textOf(mine), retained: textOf(retained), lost };
}

/** The choices of one gesture: each is merged with the text as it was when the gesture began, so that one that is called off leaves nothing. */
export class Drafts {
	#before: Design | undefined;
	#last: Written | undefined;

	/** While the hand moves. */
	edit(context: FlowerContext, descriptions: readonly Description[], run?: string): void {
		// What is there now may be of another hand: an undo, the editor, another plant.
		const { specimen } = context.state;
		if (!this.#last || valuedText(specimen) !== this.#last.text) this.#before = designIn(specimen);
		if (!this.#before) return;
		this.#last = written(this.#before, descriptions);
		context.edit({ ...textChange(specimen, this.#last.text), run }, GESTURE);
	}

	/** Its end: one step, and what was lost is told. */
	settle(context: FlowerContext): void {
		context.settle(GESTURE);
		const done = this.#last;
		this.#before = undefined;
		this.#last = undefined;
		if (done && done.lost.length > 0 && valuedText(context.state.specimen) === done.text) tell(context, done);
	}

	/** A choice by itself. */
	set(context: FlowerContext, description: Description): void {
		const design = designIn(context.state.specimen);
		if (!design) return;
		const all = descriptionsIn(design).map((each) => (each.organ === description.organ ? description : each));
		this.edit(context, all);
		this.settle(context);
	}
}

const MAX_LISTED = 4;

function tell(context: FlowerContext, { text, lost, retained }: Written): void {
	const isStill = sameDocument(context);
	const keep = () => {
		if (isStill() && valuedText(context.state.specimen) === text)
			context.set(textChange(context.state.specimen, retained));
		else context.notify("The edited lines were not kept", ["The text has changed meanwhile."], { topic: GESTURE });
	};
	const more = lost.length > MAX_LISTED ? [`and ${lost.length - MAX_LISTED} more.`] : [];
	context.notify(
		"Lines edited by hand gave way to this choice",
		[...lost.slice(0, MAX_LISTED).map((line) => line.trim()), ...more, "Undo takes the choice back."],
		{ topic: GESTURE, act: { words: "Keep the edited lines", run: keep } },
	);
}
