/**
 * Converts a flower's text to the XML of Table 4 (Petrenko 2014). Glue, splits, modules and materials have no element
 * there; they become `<statement>` elements of our own. The root is `<grammar>`. Comments are dropped, except those
 * that describe a design.
 */
import { readLine } from "../design/description";
import { scan } from "../ui/language";
import { bare, entriesOf, formsOf, inFields, statementsOf } from "../ui/statements";
import { escaped } from "./elements";
import { FIELDS } from "./fields";

type Pieces = ReturnType<typeof scan>;

/**
 * Returns the XML of a text.
 * @param text a valid text; XML of others may be incomplete
 */
export function xmlOf(text: string): string {
	const pieces = scan(text);
	const statements = statementsOf(bare(pieces));
	const forms = formsOf(statements);
	let module = "";
	const elements = statements.map((pieces) => {
		if (pieces[0].text === "#module") module = pieces[1]?.text ?? "";
		const xml = elementOf(new Statement(text, pieces), (name, of = module) => forms.get(`${of}:${name}`));
		return { from: pieces[0].from, xml };
	});
	const described = pieces
		.filter((piece) => isDescription(text, piece))
		.map((piece) => ({ from: piece.from, xml: `<statement>${escaped(piece.text)}</statement>` }));
	const lines = [...elements, ...described].sort((a, b) => a.from - b.from).map(({ xml }) => xml);
	return `<?xml version="1.0" encoding="UTF-8"?>\n<grammar>\n${lines.join("\n")}\n</grammar>\n`;
}

/** Returns whether a token is an organ's description on a line of its own. */
function isDescription(text: string, { kind, from, to, text: comment }: Pieces[number]): boolean {
	const isOnOwnLine = (from === 0 || text[from - 1] === "\n") && /^[ \t]*(?:\n|$)/.test(text.slice(to, to + 200));
	return kind === "comment" && isOnOwnLine && readLine(comment) !== undefined;
}

/** A statement that is read from left to right. */
class Statement {
	at = 0;
	constructor(
		readonly text: string,
		readonly pieces: Pieces,
	) {}

	/** Returns whether the present token is a sign. */
	on(sign: string): boolean {
		return this.here === sign;
	}

	/** Text of the present token; empty behind the last one. */
	get here(): string {
		return this.pieces[this.at]?.text ?? "";
	}

	/** Returns the text of the tokens from index `from` to before `to`, without comments. */
	slice(from: number, to: number): string {
		return this.pieces
			.slice(from, to)
			.map(({ text, from: start }, i, all) => (i > 0 && all[i - 1].to < start ? ` ${text}` : text))
			.join("");
	}
}

/**
 * Returns whether a volume's lists have a translation, or undefined if the name is no volume; with an empty name,
 * those of a module's axiom.
 */
type Form = (name: string, module?: string) => boolean | undefined;

/**
 * Writes a statement as the XML element of its kind: a definition, a volume, the axiom or a rule; statements that Table
 * 4 has no element for become `<statement>`.
 */
function elementOf(statement: Statement, form: Form): string {
	const { pieces } = statement;
	const asStatement = () => `<statement>${escaped(statement.slice(0, pieces.length))}</statement>`;
	const [head, name, sign] = pieces;
	if (head.text === "#define" && sign?.text === "=")
		return /^[\p{L}_][\p{L}\p{N}_.-]*$/u.test(name.text)
			? `<variable category="#define"><${name.text}>${escaped(statement.slice(3, pieces.length))}</${name.text}></variable>`
			: asStatement();
	if (head.text === "#define" && name) {
		statement.at = 1;
		return volumeElement(statement, "#define", form(name.text));
	}
	if (/^#axiome?$/.test(head.text)) {
		statement.at = name?.text === ":" ? 2 : 1;
		return `<axiom prefix="#axiom: ">${escaped(withFullLists(statement, form))}</axiom>`;
	}
	if (head.kind === "statement") return asStatement();
	const production = ruleElement(statement, form);
	if (production) return production;
	statement.at = 0;
	return `<statement>${escaped(withFullLists(statement, form))}</statement>`;
}

/**
 * Writes the rest of a statement with all nine numbers in each list, since definitions have nine here and shorter
 * lists would be read differently.
 */
function withFullLists(statement: Statement, form: Form): string {
	const { pieces, at } = statement;
	let written = "";
	let copiedTo = at;
	for (let i = at; i + 1 < pieces.length; i++) {
		const isList = /^\p{L}/u.test(pieces[i].text) && pieces[i + 1].text === "(" && form(pieces[i].text) !== undefined;
		if (!isList) continue;
		const [numbers, end] = numbersAt(statement, i + 1, form(pieces[i].text));
		written += `${statement.slice(copiedTo, i + 1)}(${numbers.join(",")})`;
		copiedTo = end;
		i = end - 1;
	}
	return `${written}${copiedTo > at && copiedTo < pieces.length ? " " : ""}${statement.slice(copiedTo, pieces.length)}`;
}

/** Returns the nine numbers of a list, empty where left out, and the token behind the list. */
function numbersAt(statement: Statement, open: number, translated: boolean | undefined): [string[], number] {
	const { entries, end } = entriesOf(statement.pieces, open);
	const listed = inFields(entries, translated).map((entry) => (entry ? statement.slice(...entry) : ""));
	return [FIELDS.map((_, i) => listed[i] ?? ""), end];
}

/** Writes the element of a production that grows volumes; undefined for glue and splits, which Table 4 lacks. */
function ruleElement(statement: Statement, form: Form): string | undefined {
	const { pieces } = statement;
	const isName = (i: number) => pieces[i] !== undefined && /^[\p{L}]/u.test(pieces[i].text);
	const begin = pieces[0].text === "(" ? 3 : isName(0) && isName(1) ? 1 : 0;
	const init = statement.slice(0, begin);
	statement.at = begin + 1;
	const blocks: string[] = [];
	while (statement.on("{")) blocks.push(readBlock(statement));
	if (pieces[statement.at]?.kind !== "arrow" || (blocks.length !== 0 && blocks.length !== 3)) return undefined;
	statement.at++;
	const [blockBefore = "", condition = "", blockAfter = ""] = blocks;
	const successor = [volumeElement(statement, "root", form(statement.here))];
	while (statement.on("[")) {
		const grown = grownVolume(statement, form);
		if (!grown) return undefined;
		successor.push(grown);
	}
	if (statement.at < pieces.length) return undefined;
	return `<rule>
	<predecessor init="${init}${init && " "}"><volume category="predcsr"><name>${pieces[begin].text}</name></volume>${xmlElement("block1", blockBefore)}${xmlElement("condition", condition)}${xmlElement("block2", blockAfter)}<element>-></element></predecessor>
	<successor>${successor.join("")}</successor>
</rule>`;
}

/** Reads a block in braces, and moves the statement's position behind it; returns the text between the braces. */
function readBlock(statement: Statement): string {
	const from = ++statement.at;
	while (statement.at < statement.pieces.length && !statement.on("}")) statement.at++;
	return statement.slice(from, statement.at++);
}

/**
 * Writes the element of a grown volume, `[NAME(…)]_{faces}`, and moves the statement's position behind it; undefined
 * for anything else.
 */
function grownVolume(statement: Statement, form: Form): string | undefined {
	statement.at++;
	const module = statement.on("&");
	if (module) statement.at++;
	const grown = volumeElement(
		statement,
		module ? "module" : "successor",
		module ? form("", statement.here) : form(statement.here),
	);
	if (!statement.on("]")) return undefined;
	statement.at++;
	if (statement.on("_")) statement.at++;
	const from = statement.at;
	if (statement.on("{")) {
		while (statement.at < statement.pieces.length && !statement.on("}")) statement.at++;
		statement.at++;
	} else {
		while (statement.at < statement.pieces.length && !statement.on("[")) statement.at++;
	}
	const faces = statement.slice(from, statement.at);
	return `<element>[</element>${grown}<element>]_</element><face>${faces.startsWith("{") ? escaped(faces) : `{${escaped(faces)}}`}</face>`;
}

/**
 * Writes the element of a volume, `NAME(N, T, …){settings}`, and moves the statement's position behind it.
 * @param category its attribute: whether it is a volume or a module's call
 * @param translated result of `Form` for the volume: whether its lists have the number T
 */
function volumeElement(statement: Statement, category: string, translated: boolean | undefined): string {
	const name = statement.here;
	statement.at++;
	let numbers: string[] | undefined;
	if (statement.on("(")) {
		[numbers, statement.at] = numbersAt(statement, statement.at, translated);
	}
	let settings = "";
	if (category === "module" && statement.on("{")) settings = xmlElement("settings", readBlock(statement));
	const fields = numbers ? FIELDS.map((field, i) => xmlElement(field, numbers[i] ?? "")).join("") : "";
	return `<volume category="${category}"><name>${name}</name>${fields}${settings}</volume>`;
}

/** Writes an element; an empty one as a single tag. */
const xmlElement = (name: string, text: string): string =>
	text === "" ? `<${name}/>` : `<${name}>${escaped(text)}</${name}>`;
