/**
 * Parses the XML that grammars need: elements, attributes, text, XML's five entities, character references and CDATA;
 * skips comments and instructions. Rejects document types, so that no entity is ever defined or fetched.
 */

import type { Message } from "../../../locale/texts";
import { TextError } from "../../../specimen/text_error";
import { text as catalogue } from "../messages.generated";

export interface XmlElement {
	readonly name: string;
	readonly attributes: Readonly<Record<string, string>>;
	readonly children: XmlElement[];
	/** Text between its tags, without its children's. */
	text: string;
	/** Returns its line and column, from 1; lazily, since counting columns takes linear time. */
	place(): readonly [line: number, column: number];
}

const { message } = catalogue;

/** Returns the error with a message at a line and column. */
export const errorAt = (place: readonly [line: number, column: number], problem: Message): TextError =>
	new TextError(...place, problem);

const DEEPEST = 32;
const MAX_ELEMENTS = 200_000;
const NAME = /[\p{L}_][\p{L}\p{N}_.:-]*/uy;
const ENTITIES: Readonly<Record<string, string>> = { lt: "<", gt: ">", amp: "&", quot: '"', apos: "'" };

/**
 * Parses the top-level elements of a text, one or several.
 * @throws TextError with line and column
 */
export function elementsOf(source: string): XmlElement[] {
	return new XmlReader(source.replace(/^\uFEFF/, "")).run();
}

class XmlReader {
	readonly #source: string;
	#at = 0;
	#elementCount = 0;
	/** Offsets of the beginnings of lines. */
	readonly #lines: number[] = [0];

	constructor(source: string) {
		this.#source = source;
		for (let i = source.indexOf("\n"); i >= 0; i = source.indexOf("\n", i + 1)) this.#lines.push(i + 1);
	}

	/** Returns the elements at the top level. */
	run(): XmlElement[] {
		const root: XmlElement = { name: "", attributes: {}, children: [], text: "", place: () => [1, 1] };
		const openElements = [root];
		while (this.#at < this.#source.length) {
			const innermost = openElements[openElements.length - 1];
			if (this.#skip("<!--", "-->") || this.#skip("<?", "?>")) continue;
			if (this.#startsWith("<![CDATA[")) {
				const [from, to] = this.#skipPast("<![CDATA[", "]]>");
				innermost.text += this.#source.slice(from, to);
			} else if (this.#startsWith("<!")) {
				this.#fail(message("xml_document_type"));
			} else if (this.#startsWith("</")) {
				this.#close(openElements);
			} else if (this.#startsWith("<")) {
				const element = this.#open(innermost, openElements.length);
				if (element) openElements.push(element);
			} else {
				const end = this.#source.indexOf("<", this.#at);
				const content = this.#source.slice(this.#at, end < 0 ? undefined : end);
				if (innermost === root && content.trim() !== "") {
					this.#at += content.length - content.trimStart().length;
					this.#fail(message("xml_outside"));
				}
				innermost.text += this.#unescape(content);
				this.#at += content.length;
			}
		}
		const last = openElements[openElements.length - 1];
		if (last !== root) throw errorAt(last.place(), message("xml_not_closed", { name: last.name }));
		return root.children;
	}

	/** Reads a start tag and adds its element to the parent. Returns the element if its content follows. */
	#open(parent: XmlElement, depth: number): XmlElement | undefined {
		const from = this.#at++;
		const place = () => this.#place(from);
		const name = this.#name(message("xml_name_expected"));
		const attributes: Record<string, string> = Object.create(null);
		for (;;) {
			this.#skipSpace();
			if (this.#startsWith("/>") || this.#startsWith(">")) break;
			const key = this.#name(message("xml_attribute_expected", { name }));
			this.#skipSpace();
			if (!this.#startsWith("=")) this.#fail(message("xml_equals_expected", { key }));
			this.#at++;
			this.#skipSpace();
			const quote = this.#source[this.#at];
			if (quote !== '"' && quote !== "'") this.#fail(message("xml_quote_expected", { key }));
			const end = this.#source.indexOf(quote, this.#at + 1);
			if (end < 0) this.#fail(message("xml_quote_open"));
			this.#at++;
			attributes[key] = this.#unescape(this.#source.slice(this.#at, end));
			this.#at = end + 1;
		}
		const empty = this.#startsWith("/>");
		this.#at += empty ? 2 : 1;
		if (++this.#elementCount > MAX_ELEMENTS) throw errorAt(place(), message("xml_too_many", { most: MAX_ELEMENTS }));
		if (depth > DEEPEST) throw errorAt(place(), message("xml_too_deep", { most: DEEPEST }));
		const element: XmlElement = { name, attributes, children: [], text: "", place };
		parent.children.push(element);
		return empty ? undefined : element;
	}

	/** Reads an end tag, which must name the innermost open element. */
	#close(open: XmlElement[]): void {
		const from = this.#at;
		this.#at += 2;
		const name = this.#name(message("xml_end_name_expected"));
		this.#skipSpace();
		const isComplete = this.#startsWith(">");
		const last = open[open.length - 1];
		if (isComplete && open.length > 1 && last.name === name) {
			open.pop();
			this.#at++;
			return;
		}
		if (!isComplete) this.#fail(message("xml_end_expected", { name }));
		this.#at = from;
		this.#fail(
			open.length > 1 ? message("xml_other_expected", { name: last.name }) : message("xml_closes_nothing", { name }),
		);
	}

	/** Replaces entities and character references; an unknown or unfinished one is an error at its place. */
	#unescape(text: string): string {
		return text.replace(/&([^;&<\s]{0,12});?/g, (whole, name: string, offset: number) => {
			const numbered = /^#(?:x([\da-f]{1,6})|(\d{1,7}))$/i.exec(name);
			const code = numbered ? Number.parseInt(numbered[1] ?? numbered[2], numbered[1] ? 16 : 10) : Number.NaN;
			const entity = Object.hasOwn(ENTITIES, name) ? ENTITIES[name] : undefined;
			const character = entity ?? (code > 0 && code <= 0x10ffff ? String.fromCodePoint(code) : undefined);
			if (character !== undefined && whole.endsWith(";")) return character;
			this.#at += offset;
			return this.#fail(message("xml_entity", { entity: whole }));
		});
	}

	/**
	 * Reads a name and moves the position behind it.
	 * @param otherwise the problem to report if there is none
	 */
	#name(otherwise: Message): string {
		NAME.lastIndex = this.#at;
		const [name] = NAME.exec(this.#source) ?? this.#fail(otherwise);
		this.#at += name.length;
		return name;
	}

	/** Returns whether the text at the position starts with a sign. */
	#startsWith(sign: string): boolean {
		return this.#source.startsWith(sign, this.#at);
	}

	/** Moves the position behind blanks and line ends. */
	#skipSpace(): void {
		while (/\s/.test(this.#source[this.#at] ?? "x")) this.#at++;
	}

	/** Skips a part that starts with `begin`, to the end of `end`; returns false if there is none. */
	#skip(begin: string, end: string): boolean {
		if (!this.#startsWith(begin)) return false;
		this.#skipPast(begin, end);
		return true;
	}

	/** Skips a part to the end of `end`; returns the range of its content. */
	#skipPast(begin: string, end: string): [number, number] {
		const from = this.#at + begin.length;
		const to = this.#source.indexOf(end, from);
		if (to < 0) this.#fail(message("xml_part_open", { begin, end }));
		this.#at = to + end.length;
		return [from, to];
	}

	/** Returns line and column, counted from 1, of an offset, by bisection of the lines. */
	#place(offset: number): [number, number] {
		let [low, high] = [0, this.#lines.length];
		while (high - low > 1) {
			const middle = (low + high) >> 1;
			if (this.#lines[middle] <= offset) low = middle;
			else high = middle;
		}
		return [low + 1, [...this.#source.slice(this.#lines[low], offset)].length + 1];
	}

	/** Throws an error at the position. */
	#fail(problem: Message): never {
		throw errorAt(this.#place(this.#at), problem);
	}
}

/** Escapes text for use between tags. */
export function escaped(text: string): string {
	return text.replace(/[&<]/g, (sign) => (sign === "&" ? "&amp;" : "&lt;")).replace(/\]\]>/g, "]]&gt;");
}
