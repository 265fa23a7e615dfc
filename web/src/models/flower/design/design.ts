/** Splits a flower's text into one section per organ and joins sections into a text. */
import { type Description, readLine, usual } from "./description";
import { ORGANS, type Organ } from "./organs";
import { sectionOf } from "./sections";

/** One organ's section of a text. */
export interface Section {
	readonly description: Description;
	readonly text: string;
}

export interface Design {
	/** Text before the first organ. */
	readonly head: string;
	readonly sections: readonly Section[];
}

/**
 * Splits a text into its sections, in linear time, since links may bring any text. Returns undefined unless the text
 * describes all six organs, each once and in their order.
 */
export function designOf(text: string): Design | undefined {
	const parts = partsOf(text);
	const head = readLine(firstLine(parts[0])) ? "" : (parts.shift() ?? "");
	const sections = parts.map((part) => ({ description: readLine(firstLine(part)), text: part }));
	const organs = sections.map(({ description }) => description?.organ);
	if (organs.length !== ORGANS.length || !ORGANS.every((organ, i) => organs[i] === organ)) return undefined;
	return { head, sections: sections as Section[] };
}

/**
 * Splits a text at the lines that begin an organ; the first part is the text before the first organ, if there is any.
 */
function partsOf(text: string): string[] {
	const starts = [...text.matchAll(/^@organ \w[^@\n]*@[ \t]*$/gm)].map(({ index }) => index);
	const cuts = starts[0] === 0 ? starts : [0, ...starts];
	return cuts.map((from, at) => text.slice(from, cuts[at + 1]));
}

/** Returns the first line of a text. */
const firstLine = (text: string): string => text.split("\n", 1)[0];

/** Joins a design's head and sections into its text. */
export const textOf = ({ head, sections }: Design): string => head + sections.map(({ text }) => text).join("");

/** Returns the text of a flower with these descriptions; organs without a description get default values. */
export function assembled(descriptions: readonly Description[] = [], head = ""): string {
	return (
		head + ORGANS.map((organ) => sectionOf(descriptions.find((each) => each.organ === organ) ?? usual(organ))).join("")
	);
}

/** Returns a design's description of one organ. */
export function describedIn({ sections }: Design, organ: Organ): Description {
	return sections[ORGANS.indexOf(organ)].description;
}
