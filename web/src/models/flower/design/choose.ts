/** Writes a choice into a text: rewrites the organ's section and merges edits made by hand into it. */
import type { Description } from "./description";
import { type Design, textOf } from "./design";
import { merged } from "./merge";
import { sectionOf } from "./sections";

export interface Chosen {
	readonly text: string;
	/** Lines edited by hand that the choice overwrites. */
	readonly lost: readonly string[];
	/** The text with the lines in `lost` retained instead. */
	readonly retained: string;
}

/**
 * Returns the text of a design with one organ described anew; edits made by hand are merged into the organ's new
 * section.
 */
export function choose(design: Design, description: Description): Chosen {
	const at = design.sections.findIndex((section) => section.description.organ === description.organ);
	const { description: before, text } = design.sections[at];
	const withText = (lines: readonly string[]): string =>
		textOf({
			...design,
			sections: design.sections.map((section, i) => (i === at ? { ...section, text: lines.join("\n") } : section)),
		});
	// The description's line always comes from the choice, however it was written before.
	const [base, edited, [firstLine, ...generated]] = [sectionOf(before), text, sectionOf(description)].map((each) =>
		each.split("\n"),
	);
	const { lines, lost, retained } = merged(base.slice(1), edited.slice(1), generated);
	return {
		text: withText([firstLine, ...lines]),
		lost: lost.filter((line) => line.trim() !== ""),
		retained: withText([firstLine, ...retained]),
	};
}

/** Returns whether a section differs, below its description, from the one that its description generates. */
export const isEdited = ({ description, text }: Design["sections"][number]): boolean =>
	belowLine(text) !== belowLine(sectionOf(description));

/** Returns a section without its first line, the description. */
const belowLine = (section: string): string => section.slice(section.indexOf("\n"));

/** Returns the text with one organ's section regenerated from its description, without edits made by hand. */
export function madeAnew(design: Design, organ: Description["organ"]): string {
	const sections = design.sections.map((section) =>
		section.description.organ === organ ? { ...section, text: sectionOf(section.description) } : section,
	);
	return textOf({ ...design, sections });
}
