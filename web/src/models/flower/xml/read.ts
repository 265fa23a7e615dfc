/** Converts the XML of a flower's grammar (Petrenko 2014, Table 4) to its text. */

import { formatList } from "../../../locale/format";
import type { Message } from "../../../locale/texts";
import { text as catalogue } from "../messages.generated";
import { elementsOf, errorAt, type XmlElement } from "./elements";
import { FIELDS } from "./fields";

const { message } = catalogue;

const PARTS = new Set(["volume", "variable", "axiom", "rule", "statement"]);

/**
 * Returns the text of an XML file: elements of Table 4, at the top level or inside one root of any name.
 * @throws TextError with the line and column of the XML
 */
export function textOfXml(source: string): string {
	let top = elementsOf(source);
	if (top.length === 1 && !PARTS.has(top[0].name)) top = top[0].children;
	if (top.length === 0) throw errorAt([1, 1], message("xml_no_grammar"));
	return `${top.map(statementOf).join("\n")}\n`;
}

/** Writes one statement of the text, or a `#define` for each variable of a `variable` element. */
function statementOf(element: XmlElement): string {
	switch (element.name) {
		case "volume":
			return `#define ${volumeText(element)}`;
		case "variable":
			if (element.children.length === 0) fail(element, message("xml_variable"));
			return element.children.map((child) => `#define ${child.name}=${requiredText(child)}`).join("\n");
		case "axiom":
			return `#axiom: ${requiredText(element)}`;
		case "rule":
			return productionText(element);
		case "statement":
			return requiredText(element);
		default:
			return fail(element, message("xml_unknown_statement", { name: element.name }));
	}
}

/**
 * Writes a production: its `init` if any, the predecessor with its blocks and condition, the arrow, the successor.
 */
function productionText(element: XmlElement): string {
	const [predecessor, successor] = ["predecessor", "successor"].map(
		(name) =>
			element.children.find((child) => child.name === name) ?? fail(element, message("xml_rule_lacks", { name })),
	);
	const init = (predecessor.attributes.init ?? "").trim();
	const predecessorVolume =
		predecessor.children.find(({ name }) => name === "volume") ?? fail(predecessor, message("xml_predecessor_volume"));
	if (numbersOf(predecessorVolume).some((number) => number !== ""))
		fail(predecessorVolume, message("xml_predecessor_numbers"));
	const block = (name: string) => oneLine(predecessor.children.find((child) => child.name === name));
	const blocks = ["block1", "condition", "block2"].map(block);
	const between = blocks.some((each) => each !== "") ? blocks.map((each) => `{${each}}`).join("") : "";
	return `${init}${init && " "}${nameOf(predecessorVolume)}${between} -> ${successor.children.map(successorPiece).join("")}`;
}

/**
 * Writes one piece of a production's successor: a volume (a module's call begins with `&`), a sign as it stands, or a
 * face in braces.
 */
function successorPiece(element: XmlElement): string {
	switch (element.name) {
		case "volume":
			return (element.attributes.category === "module" ? "&" : "") + volumeText(element);
		case "element":
			return oneLine(element);
		case "face": {
			const face = oneLine(element);
			return face.startsWith("{") ? face : `{${face}}`;
		}
		default:
			return fail(element, message("xml_unknown_piece", { name: element.name }));
	}
}

/** Writes a volume: `NAME(N, T, …){…}`, without the list if it has no numbers. */
function volumeText(element: XmlElement): string {
	const fields = new Set<string>(["name", "settings", ...FIELDS]);
	const unknownChild = element.children.find(({ name }) => !fields.has(name));
	if (unknownChild)
		fail(unknownChild, message("xml_unknown_field", { name: unknownChild.name, fields: formatList(fields) }));
	const numbers = numbersOf(element);
	const settings = element.children.find(({ name }) => name === "settings");
	const hasList =
		element.attributes.category === "#define" ? element.children.length > 1 : numbers.some((each) => each !== "");
	return `${nameOf(element)}${hasList ? `(${numbers.join(",")})` : ""}${settings ? `{${oneLine(settings)}}` : ""}`;
}

/** Returns the texts of a volume's numbers, in the order of `FIELDS`; empty for those left out. */
function numbersOf({ children }: XmlElement): string[] {
	return FIELDS.map((field) => oneLine(children.find(({ name }) => name === field)));
}

/** Returns the name of a volume; fails if there is none. */
function nameOf(element: XmlElement): string {
	const name = element.children.find((child) => child.name === "name") ?? fail(element, message("xml_volume_name"));
	return requiredText(name);
}

/** Returns the text of an element; fails if it is empty. */
function requiredText(element: XmlElement): string {
	return oneLine(element) || fail(element, message("xml_empty", { name: element.name }));
}

/** Joins an element's text into one line, since a statement ends with its line. */
function oneLine(element: XmlElement | undefined): string {
	if (element && element.children.length > 0)
		fail(element.children[0], message("xml_no_elements", { name: element.name }));
	return (element?.text ?? "").trim().replace(/\s+/g, " ");
}

/** Throws an error at an element's place. */
function fail(element: XmlElement, problem: Message): never {
	throw errorAt(element.place(), problem);
}
