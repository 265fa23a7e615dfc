/** A choice written into a text: its organ's section is made anew, and what was edited in it by hand is merged in. */
import type { Description } from "./description";
import { type Design, textOf } from "./design";
import { merged } from "./merge";
import { sectionOf } from "./sections";

export interface Chosen {
	readonly text: string;
	/** Lines edited by hand that the choice does not leave. */
	readonly lost: readonly string[];
	/** The text with those lines retained. */
	readonly retained: string;
}

/** The text of a design with one organ described otherwise. */
export function choose(design: Design, description: Description): Chosen {
	const at = design.sections.findIndex((section) => section.description.organ === description.organ);
	const { description: before, text } = design.sections[at];
	const withText = (lines: readonly string[]): string =>
		textOf({
			...design,
			sections: design.sections.map((section, i) => (i === at ? { ...section, text: lines.join("\n") } : section)),
		});
	// The line of the description itself is the choice's, however it was written.
	const [base, mine, [said, ...made]] = [sectionOf(before), text, sectionOf(description)].map((each) =>
		each.split("\n"),
	);
	const { lines, lost, retained } = merged(base.slice(1), mine.slice(1), made);
	return {
		text: withText([said, ...lines]),
		lost: lost.filter((line) => line.trim() !== ""),
		retained: withText([said, ...retained]),
	};
}

/** Whether a section is not what its description makes, however that is written. */
export const isEdited = ({ description, text }: Design["sections"][number]): boolean =>
	belowLine(text) !== belowLine(sectionOf(description));

const belowLine = (section: string): string => section.slice(section.indexOf("\n"));

/** The text with one organ's section as its description makes it. */
export function madeAnew(design: Design, organ: Description["organ"]): string {
	const sections = design.sections.map((section) =>
		section.description.organ === organ ? { ...section, text: sectionOf(section.description) } : section,
	);
	return textOf({ ...design, sections });
}
