/**
 * A flower's text → the XML of Table 4 (Petrenko 2014). What that has no element for (glue, splits, modules, materials) stands as it is in
 * a `<statement>` of ours, and all in one `<grammar>`, since XML wants a root. Comments are left out, but for those that describe a design.
 */
import { readLine } from "../design/description";
import { scan } from "../ui/language";
import { bare, entriesOf, formsOf, inFields, statementsOf } from "../ui/statements";
import { escaped } from "./elements";
import { FIELDS } from "./fields";

type Pieces = ReturnType<typeof scan>;

/** @param text one that has grown: of another the XML may say less */
export function xmlOf(text: string): string {
	const pieces = scan(text);
	const statements = statementsOf(bare(pieces));
	const forms = formsOf(statements);
	let module = "";
	const elements = statements.map((pieces) => {
		if (pieces[0].text === "#module") module = pieces[1]?.text ?? "";
		const said = element(new Statement(text, pieces), (name, of = module) => forms.get(`${of}:${name}`));
		return { from: pieces[0].from, said };
	});
	const described = pieces
		.filter((piece) => isDescription(text, piece))
		.map((piece) => ({ from: piece.from, said: `<statement>${escaped(piece.text)}</statement>` }));
	const lines = [...elements, ...described].sort((one, other) => one.from - other.from).map(({ said }) => said);
	return `<?xml version="1.0" encoding="UTF-8"?>\n<grammar>\n${lines.join("\n")}\n</grammar>\n`;
}

/** Whether a piece is an organ's description on a line of its own, as a design has it. */
function isDescription(text: string, { kind, from, to, text: said }: Pieces[number]): boolean {
	const alone = (from === 0 || text[from - 1] === "\n") && /^[ \t]*(?:\n|$)/.test(text.slice(to, to + 200));
	return kind === "comment" && alone && readLine(said) !== undefined;
}

/** A statement, read from the left. */
class Statement {
	at = 0;
	constructor(
		readonly text: string,
		readonly pieces: Pieces,
	) {}

	on(sign: string): boolean {
		return this.here === sign;
	}

	get here(): string {
		return this.pieces[this.at]?.text ?? "";
	}

	/** Comments within are left out. */
	slice(from: number, to: number): string {
		return this.pieces
			.slice(from, to)
			.map(({ text, from: start }, i, all) => (i > 0 && all[i - 1].to < start ? ` ${text}` : text))
			.join("");
	}
}

/** Whether lists of a volume have a translation, undefined of what is none; of a module with an empty name, what it begins with. */
type Form = (name: string, module?: string) => boolean | undefined;

function element(statement: Statement, form: Form): string {
	const { pieces } = statement;
	const whole = () => `<statement>${escaped(statement.slice(0, pieces.length))}</statement>`;
	const [head, name, sign] = pieces;
	if (head.text === "#define" && sign?.text === "=")
		return /^[\p{L}_][\p{L}\p{N}_.-]*$/u.test(name.text)
			? `<variable category="#define"><${name.text}>${escaped(statement.slice(3, pieces.length))}</${name.text}></variable>`
			: whole();
	if (head.text === "#define" && name) {
		statement.at = 1;
		return volume(statement, "#define", form(name.text));
	}
	if (/^#axiome?$/.test(head.text)) {
		statement.at = name?.text === ":" ? 2 : 1;
		return `<axiom prefix="#axiom: ">${escaped(spelledOut(statement, form))}</axiom>`;
	}
	if (head.kind === "statement") return whole();
	const grows = rule(statement, form);
	if (grows) return grows;
	statement.at = 0;
	return `<statement>${escaped(spelledOut(statement, form))}</statement>`;
}

/** The rest of a statement, lists of volumes with all nine numbers: as definitions have them here, so that shorter ones would say others. */
function spelledOut(statement: Statement, form: Form): string {
	const { pieces, at } = statement;
	let written = "";
	let from = at;
	for (let i = at; i + 1 < pieces.length; i++) {
		const listed = /^\p{L}/u.test(pieces[i].text) && pieces[i + 1].text === "(" && form(pieces[i].text) !== undefined;
		if (!listed) continue;
		const [numbers, end] = numbersAt(statement, i + 1, form(pieces[i].text));
		written += `${statement.slice(from, i + 1)}(${numbers.join(",")})`;
		from = end;
		i = end - 1;
	}
	return `${written}${from > at && from < pieces.length ? " " : ""}${statement.slice(from, pieces.length)}`;
}

/** The nine numbers of a list that opens at a piece, empty where they are left out; and the piece behind it. */
function numbersAt(statement: Statement, open: number, translated: boolean | undefined): [string[], number] {
	const { entries, end } = entriesOf(statement.pieces, open);
	const said = inFields(entries, translated).map((entry) => (entry ? statement.slice(...entry) : ""));
	return [FIELDS.map((_, i) => said[i] ?? ""), end];
}

/** A production that grows something; undefined of one that glues or splits. */
function rule(statement: Statement, form: Form): string | undefined {
	const { pieces } = statement;
	const isName = (i: number) => pieces[i] !== undefined && /^[\p{L}]/u.test(pieces[i].text);
	const begin = pieces[0].text === "(" ? 3 : isName(0) && isName(1) ? 1 : 0;
	const init = statement.slice(0, begin);
	statement.at = begin + 1;
	const blocks: string[] = [];
	while (statement.on("{")) blocks.push(block(statement));
	if (pieces[statement.at]?.kind !== "arrow" || (blocks.length !== 0 && blocks.length !== 3)) return undefined;
	statement.at++;
	const [first = "", second = "", third = ""] = blocks;
	const successor = [volume(statement, "root", form(statement.here))];
	while (statement.on("[")) {
		const grown = growth(statement, form);
		if (!grown) return undefined;
		successor.push(grown);
	}
	if (statement.at < pieces.length) return undefined;
	return `<rule>
	<predecessor init="${init}${init && " "}"><volume category="predcsr"><name>${pieces[begin].text}</name></volume>${tagged("block1", first)}${tagged("condition", second)}${tagged("block2", third)}<element>-></element></predecessor>
	<successor>${successor.join("")}</successor>
</rule>`;
}

function block(statement: Statement): string {
	const from = ++statement.at;
	while (statement.at < statement.pieces.length && !statement.on("}")) statement.at++;
	return statement.slice(from, statement.at++);
}

/** `[NAME(…)]_{faces}` */
function growth(statement: Statement, form: Form): string | undefined {
	statement.at++;
	const module = statement.on("&");
	if (module) statement.at++;
	const grown = volume(
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

function volume(statement: Statement, category: string, translated: boolean | undefined): string {
	const name = statement.here;
	statement.at++;
	let numbers: string[] | undefined;
	if (statement.on("(")) {
		[numbers, statement.at] = numbersAt(statement, statement.at, translated);
	}
	let settings = "";
	if (category === "module" && statement.on("{")) settings = tagged("settings", block(statement));
	const fields = numbers ? FIELDS.map((field, i) => tagged(field, numbers[i] ?? "")).join("") : "";
	return `<volume category="${category}"><name>${name}</name>${fields}${settings}</volume>`;
}

const tagged = (name: string, text: string): string =>
	text === "" ? `<${name}/>` : `<${name}>${escaped(text)}</${name}>`;
