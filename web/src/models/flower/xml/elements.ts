/**
 * Parses the XML that grammars need: elements, attributes, text, XML's five entities, character references and CDATA;
 * skips comments and instructions. Rejects document types, so that no entity is ever defined or fetched.
 */
import { TextError } from "../../../specimen/text_error";

export interface XmlElement {
	readonly name: string;
	readonly attributes: Readonly<Record<string, string>>;
	readonly children: XmlElement[];
	/** Text between its tags, without its children's. */
	text: string;
	/** Returns its line and column, from 1; lazily, since counting columns takes linear time. */
	place(): readonly [line: number, column: number];
}

const DEEPEST = 32;
const MOST = 200_000;
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
	#made = 0;
	/** Offsets of the beginnings of lines. */
	readonly #lines: number[] = [0];

	constructor(source: string) {
		this.#source = source;
		for (let i = source.indexOf("\n"); i >= 0; i = source.indexOf("\n", i + 1)) this.#lines.push(i + 1);
	}

	run(): XmlElement[] {
		const top: XmlElement = { name: "", attributes: {}, children: [], text: "", place: () => [1, 1] };
		const open = [top];
		while (this.#at < this.#source.length) {
			const inner = open[open.length - 1];
			if (this.#passed("<!--", "-->") || this.#passed("<?", "?>")) continue;
			if (this.#on("<![CDATA[")) {
				const [from, to] = this.#through("<![CDATA[", "]]>");
				inner.text += this.#source.slice(from, to);
			} else if (this.#on("<!")) {
				this.#wrong("A document type is not read; take it out. What entities stand for is written in their place.");
			} else if (this.#on("</")) {
				this.#close(open);
			} else if (this.#on("<")) {
				const element = this.#open(inner, open.length);
				if (element) open.push(element);
			} else {
				const end = this.#source.indexOf("<", this.#at);
				const stretch = this.#source.slice(this.#at, end < 0 ? undefined : end);
				if (inner === top && stretch.trim() !== "") {
					this.#at += stretch.length - stretch.trimStart().length;
					this.#wrong("Nothing stands outside of elements.");
				}
				inner.text += this.#unescaped(stretch);
				this.#at += stretch.length;
			}
		}
		const last = open[open.length - 1];
		if (last !== top) throw new TextError(...last.place(), `<${last.name}> is never closed.`);
		return top.children;
	}

	#open(parent: XmlElement, depth: number): XmlElement | undefined {
		const from = this.#at++;
		const place = () => this.#place(from);
		const name = this.#name("An element's name stands behind <.");
		const attributes: Record<string, string> = Object.create(null);
		for (;;) {
			this.#space();
			if (this.#on("/>") || this.#on(">")) break;
			const key = this.#name(`<${name}> goes on with an attribute or >.`);
			this.#space();
			if (!this.#on("=")) this.#wrong(`An = stands behind ${key}.`);
			this.#at++;
			this.#space();
			const quote = this.#source[this.#at];
			if (quote !== '"' && quote !== "'") this.#wrong(`What ${key} is stands in quotes.`);
			const end = this.#source.indexOf(quote, this.#at + 1);
			if (end < 0) this.#wrong("This quote is never closed.");
			this.#at++;
			attributes[key] = this.#unescaped(this.#source.slice(this.#at, end));
			this.#at = end + 1;
		}
		const empty = this.#on("/>");
		this.#at += empty ? 2 : 1;
		if (++this.#made > MOST)
			throw new TextError(...place(), `There are more than ${MOST.toLocaleString("en")} elements.`);
		if (depth > DEEPEST) throw new TextError(...place(), `Elements stand in one another more than ${DEEPEST} deep.`);
		const element: XmlElement = { name, attributes, children: [], text: "", place };
		parent.children.push(element);
		return empty ? undefined : element;
	}

	#close(open: XmlElement[]): void {
		const from = this.#at;
		this.#at += 2;
		const name = this.#name("An element's name stands behind </.");
		this.#space();
		const ends = this.#on(">");
		const last = open[open.length - 1];
		if (ends && open.length > 1 && last.name === name) {
			open.pop();
			this.#at++;
			return;
		}
		if (!ends) this.#wrong(`A > ends </${name}.`);
		this.#at = from;
		this.#wrong(open.length > 1 ? `</${last.name}> is expected here.` : `</${name}> closes nothing.`);
	}

	#unescaped(text: string): string {
		return text.replace(/&([^;&<\s]{0,12});?/g, (whole, name: string, offset: number) => {
			const numbered = /^#(?:x([\da-f]{1,6})|(\d{1,7}))$/i.exec(name);
			const code = numbered ? Number.parseInt(numbered[1] ?? numbered[2], numbered[1] ? 16 : 10) : Number.NaN;
			const known = Object.hasOwn(ENTITIES, name) ? ENTITIES[name] : undefined;
			const meant = known ?? (code > 0 && code <= 0x10ffff ? String.fromCodePoint(code) : undefined);
			if (meant !== undefined && whole.endsWith(";")) return meant;
			this.#at += offset;
			return this.#wrong(`${whole} stands for nothing here; an & by itself is &amp;.`);
		});
	}

	#name(otherwise: string): string {
		NAME.lastIndex = this.#at;
		const [name] = NAME.exec(this.#source) ?? this.#wrong(otherwise);
		this.#at += name.length;
		return name;
	}

	#on(sign: string): boolean {
		return this.#source.startsWith(sign, this.#at);
	}

	#space(): void {
		while (/\s/.test(this.#source[this.#at] ?? "x")) this.#at++;
	}

	#passed(begin: string, end: string): boolean {
		if (!this.#on(begin)) return false;
		this.#through(begin, end);
		return true;
	}

	#through(begin: string, end: string): [number, number] {
		const from = this.#at + begin.length;
		const to = this.#source.indexOf(end, from);
		if (to < 0) this.#wrong(`This ${begin} is never closed; ${end} ends it.`);
		this.#at = to + end.length;
		return [from, to];
	}

	#place(at: number): [number, number] {
		let [low, high] = [0, this.#lines.length];
		while (high - low > 1) {
			const middle = (low + high) >> 1;
			if (this.#lines[middle] <= at) low = middle;
			else high = middle;
		}
		return [low + 1, [...this.#source.slice(this.#lines[low], at)].length + 1];
	}

	#wrong(message: string): never {
		throw new TextError(...this.#place(this.#at), message);
	}
}

/** Escapes text for use between tags. */
export function escaped(text: string): string {
	return text.replace(/[&<]/g, (sign) => (sign === "&" ? "&amp;" : "&lt;")).replace(/\]\]>/g, "]]&gt;");
}
