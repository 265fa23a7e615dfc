/** Converts the XML of a flower's grammar (Petrenko 2014, Table 4) to its text. */
import { TextError } from "../../../specimen/text_error";
import { elementsOf, type XmlElement } from "./elements";
import { FIELDS } from "./fields";

const PARTS = new Set(["volume", "variable", "axiom", "rule", "statement"]);

/**
 * Returns the text of an XML file: elements of Table 4, at the top level or inside one root of any name.
 * @throws TextError with the line and column of the XML
 */
export function textOfXml(source: string): string {
	let top = elementsOf(source);
	if (top.length === 1 && !PARTS.has(top[0].name)) top = top[0].children;
	if (top.length === 0) throw new TextError(1, 1, "There is no grammar in it: no volume, variable, axiom or rule.");
	return `${top.map(statementOf).join("\n")}\n`;
}

function statementOf(element: XmlElement): string {
	switch (element.name) {
		case "volume":
			return `#define ${volume(element)}`;
		case "variable":
			if (element.children.length === 0)
				wrong(element, "A variable has an element of its name, as in <thickness>7</thickness>.");
			return element.children.map((child) => `#define ${child.name}=${value(child)}`).join("\n");
		case "axiom":
			return `#axiom: ${value(element)}`;
		case "rule":
			return rule(element);
		case "statement":
			return value(element);
		default:
			return wrong(element, `<${element.name}> is none of volume, variable, axiom, rule and statement.`);
	}
}

function rule(element: XmlElement): string {
	const [before, after] = ["predecessor", "successor"].map(
		(name) => element.children.find((child) => child.name === name) ?? wrong(element, `A rule has a <${name}>.`),
	);
	const init = (before.attributes.init ?? "").trim();
	const grown = before.children.find(({ name }) => name === "volume") ?? wrong(before, "A predecessor has a <volume>.");
	if (numbersOf(grown).some((number) => number !== ""))
		wrong(grown, "A predecessor has a name and no numbers; leave them empty.");
	const block = (name: string) => oneLine(before.children.find((child) => child.name === name));
	const blocks = ["block1", "condition", "block2"].map(block);
	const between = blocks.some((each) => each !== "") ? blocks.map((each) => `{${each}}`).join("") : "";
	return `${init}${init && " "}${nameOf(grown)}${between} -> ${after.children.map(piece).join("")}`;
}

/** Writes the successor: volumes, signs and faces in order. */
function piece(element: XmlElement): string {
	switch (element.name) {
		case "volume":
			return (element.attributes.category === "module" ? "&" : "") + volume(element);
		case "element":
			return oneLine(element);
		case "face": {
			const face = oneLine(element);
			return face.startsWith("{") ? face : `{${face}}`;
		}
		default:
			return wrong(element, `<${element.name}> is none of volume, element and face.`);
	}
}

/** Writes a volume: `NAME(N, T, …){…}`, without the list if it has no numbers. */
function volume(element: XmlElement): string {
	const known = new Set<string>(["name", "settings", ...FIELDS]);
	const strange = element.children.find(({ name }) => !known.has(name));
	if (strange) wrong(strange, `A volume has no <${strange.name}>; it has ${[...known].join(", ")}.`);
	const numbers = numbersOf(element);
	const settings = element.children.find(({ name }) => name === "settings");
	const listed =
		element.attributes.category === "#define" ? element.children.length > 1 : numbers.some((each) => each !== "");
	return `${nameOf(element)}${listed ? `(${numbers.join(",")})` : ""}${settings ? `{${oneLine(settings)}}` : ""}`;
}

function numbersOf({ children }: XmlElement): string[] {
	return FIELDS.map((field) => oneLine(children.find(({ name }) => name === field)));
}

function nameOf(element: XmlElement): string {
	const name = element.children.find((child) => child.name === "name") ?? wrong(element, "A volume has a <name>.");
	return value(name);
}

function value(element: XmlElement): string {
	return oneLine(element) || wrong(element, `<${element.name}> is empty.`);
}

/** Joins an element's text into one line, since a statement ends with its line. */
function oneLine(element: XmlElement | undefined): string {
	if (element && element.children.length > 0)
		wrong(element.children[0], `<${element.name}> has text in it and no elements.`);
	return (element?.text ?? "").trim().replace(/\s+/g, " ");
}

function wrong(element: XmlElement, message: string): never {
	throw new TextError(...element.place(), message);
}
