/** Outline of a grammar's text, for controls: its constants, curves and numbers. */
import { insideComment } from "./comments";
import { findRange, type RangeWords, trimSeparators, unitIn } from "./range_words";
import { scan, type Token } from "./scan";

/** A number in a text, including its sign. */
export interface NumberAt {
	readonly from: number;
	readonly to: number;
	/** As it is written: `-0.50`. */
	readonly text: string;
	readonly value: number;
}

/** Range of a slider. */
export interface NumberRange {
	readonly min: number;
	readonly max: number;
	readonly step: number;
}

/** A `#define` whose value is a number. */
export interface Constant extends NumberRange {
	readonly name: string;
	readonly line: number;
	readonly number: NumberAt;
	/** Whether the comment behind the number contains the range; else the range is a guess. */
	readonly isRanged: boolean;
	/** Text of the comment behind the number, without the range; may be empty. */
	readonly description: string;
	/** The unit with which the description begins: "mm", "°"; empty if it begins with none. */
	readonly unit: string;
}

/** Name and range of a `#define`'s value in the text. */
export interface Definition {
	readonly name: string;
	readonly from: number;
	readonly to: number;
}

/** A `#curve`: a function through points. */
export interface Curve {
	readonly name: string;
	readonly line: number;
	/** Range of the points in the text. */
	readonly from: number;
	readonly to: number;
	readonly points: readonly (readonly [x: number, y: number])[];
}

/** Outline of a grammar's text. */
export interface GrammarOutline {
	readonly pieces: readonly Token[];
	readonly constants: readonly Constant[];
	/** Constants, and definitions with computed values. */
	readonly definitions: readonly Definition[];
	readonly curves: readonly Curve[];
	/** Source lines of constants, inputs and curves, by name. */
	readonly names: ReadonlyMap<string, string>;
	/** Symbols in the axiom or in productions, with the text of their first occurrence with parameters. */
	readonly symbols: ReadonlyMap<string, string>;
}

/**
 * Reads the outline of a text; unreadable parts are left out.
 * @param pieces tokens of the text, if its language is not L-systems
 */
export function outlineOf(text: string, pieces: readonly Token[] = scan(text)): GrammarOutline {
	const constants: Constant[] = [];
	const definitions: Definition[] = [];
	const curves: Curve[] = [];
	const names = new Map<string, string>();
	for (const line of byStatement(pieces)) {
		const [head, name] = line;
		const word = wordOf(head);
		// The module's body is a grammar with its own names.
		if (word === "#module") break;
		if (name?.kind !== "name" && name?.kind !== "function") continue;
		if (!/^#(?:define|input|curve)$/.test(word)) continue;
		names.set(name.text, text.slice(head.from, line.findLast(({ kind }) => kind !== "comment")?.to));
		if (word === "#define") {
			constants.push(...constantIn(line));
			definitions.push(...definitionIn(line));
		}
		if (word === "#curve") curves.push(...curveIn(line));
	}
	return { pieces, constants, definitions, curves, names, symbols: symbolsIn(pieces, text) };
}

/** Returns the number at a position of the text, its ends and its sign included; undefined if there is none. */
export function numberAt(pieces: readonly Token[], place: number): NumberAt | undefined {
	const index = pieces.findIndex(({ kind, from, to }) => kind === "number" && from <= place && place <= to);
	if (index >= 0) return signedNumber(pieces, index);
	// The position is on the number's sign.
	const sign = pieces.findIndex(({ kind, from }) => kind === "number" && from === place + 1);
	const number = sign > 0 ? signedNumber(pieces, sign) : undefined;
	return number && number.from <= place ? number : undefined;
}

/** Returns the keyword of a statement; `# define` gives `#define`. */
export const wordOf = ({ text }: Token): string => text.replace(/^#\s+/, "#");

/**
 * Replaces the values of definitions in a text; presets that share a text differ by these values.
 * @param pieces tokens, as for `outlineOf`
 */
export function withConstants(
	text: string,
	values: Readonly<Partial<Record<string, number>>>,
	pieces?: readonly Token[],
): string {
	const parts: string[] = [];
	let done = 0;
	for (const { name, from, to } of outlineOf(text, pieces).definitions) {
		if (!Object.hasOwn(values, name)) continue;
		parts.push(text.slice(done, from), String(values[name]));
		done = to;
	}
	return parts.join("") + text.slice(done);
}

/**
 * Yields the tokens of each statement up to the end of its line; the line continues within brackets and after `<`.
 */
function* byStatement(pieces: readonly Token[]): Iterable<Token[]> {
	for (let start = 0; start < pieces.length; start++) {
		if (pieces[start].kind !== "statement") continue;
		let [end, line, open, last] = [start + 1, pieces[start].line, 0, ""];
		for (; end < pieces.length; end++) {
			const piece = pieces[end];
			if (piece.line > line && (piece.kind === "statement" || (open <= 0 && last !== "<"))) break;
			line = piece.line;
			if (piece.kind === "comment") continue;
			open += Number(/^[([{]$/.test(piece.text)) - Number(/^[)\]}]$/.test(piece.text));
			last = piece.text;
		}
		yield pieces.slice(start, end);
	}
}

/**
 * Returns the name of a `#define` line and the range of its value in the text; none for lists, volumes and functions.
 */
function definitionIn([, name, ...rest]: readonly Token[]): Definition[] {
	const body = rest.filter(({ kind, text }, index) => kind !== "comment" && !(index === 0 && text === "="));
	if (name.kind !== "name" || body.length === 0 || body[0].text === "[" || isFunction(name, body)) return [];
	return [{ name: name.text, from: body[0].from, to: body[body.length - 1].to }];
}

/**
 * Returns whether a definition is a function: `f(x) x*2`, with parentheses directly behind the name; `f(x)` alone is a
 * value.
 */
function isFunction(name: Token, [open, first, next, ...rest]: readonly Token[]): boolean {
	const named = first?.kind === "name" || first?.kind === "function";
	return (
		open.text === "(" &&
		open.from === name.to &&
		named &&
		(next?.text === "," || (next?.text === ")" && rest.length > 0))
	);
}

/**
 * Reads the constant in a `#define` line whose value is a single number; its range is read from the comment behind it,
 * or guessed. Returns one constant or none.
 */
function constantIn(line: readonly Token[]): Constant[] {
	const [head, name, ...rest] = line;
	const values = rest.filter(({ kind, text }, index) => kind !== "comment" && !(index === 0 && text === "="));
	const at = line.findIndex(({ kind }) => kind === "number");
	if (at < 0) return [];
	const number = signedNumber(line, at);
	// Only a single number counts.
	if (number.from !== values[0].from || number.to !== values.at(-1)?.to) return [];
	const comment = insideComment(rest.findLast(({ kind }) => kind === "comment")?.text ?? "");
	const writtenRange = findRange(comment);
	const range = writtenRange ? rangeIn(writtenRange, number) : guessRange(name.text, number);
	const description = trimSeparators(writtenRange?.description ?? comment);
	const isRanged = writtenRange !== undefined;
	return [{ name: name.text, line: head.line, number, isRanged, description, unit: unitIn(description), ...range }];
}

/** Returns the number of a text whose sign may be a typographic minus. */
const readSigned = (text: string) => Number(text.replace("−", "-"));

/** Returns the range that a comment describes, extended to contain the value. */
function rangeIn({ low, high, step }: RangeWords, { text, value }: NumberAt): NumberRange {
	const ends = [readSigned(low), readSigned(high), value];
	const [min, max] = [Math.min(...ends), Math.max(...ends)];
	const writtenStep = step === undefined ? 0 : Math.abs(readSigned(step));
	return { min, max, step: writtenStep || stepFor(max - min, Math.max(...[low, high, text].map(decimals))) };
}

/** Names of angles. Values of at most 1 are shares, under any name. */
const ANGLE = /^(?:a|angle|alpha|beta|gamma|delta|theta|phi|psi|yaw|roll|pitch|turn|[αβγδθφψ])(?:_|\d|$)/i;

/**
 * Guesses the range of a constant without a written one: degrees if the name is an angle's, 0 … 1 for shares, else up
 * to twice its value.
 */
function guessRange(name: string, { text, value }: NumberAt): NumberRange {
	const places = decimals(text);
	const size = Math.abs(value);
	const limit = size > 180 ? 360 : 180;
	if (ANGLE.test(name) && size <= 360 && size > 1)
		return { min: value < 0 ? -limit : 0, max: limit, step: stepFor(limit, places) };
	if (value === 0) return { min: places > 0 ? -1 : -10, max: places > 0 ? 1 : 10, step: places > 0 ? 0.01 : 1 };
	const max = size <= 1 && places > 0 ? 1 : roundUp(2 * size);
	return { min: value < 0 ? -max : 0, max, step: stepFor(max, places) };
}

/** Rounds up to 1, 2, 3, 5 or 10 times a power of ten. */
function roundUp(value: number): number {
	const unit = 10 ** Math.floor(Math.log10(value));
	const times = [1, 2, 3, 5, 10].find((each) => each * unit >= value * (1 - 1e-9)) ?? 10;
	return Number((times * unit).toPrecision(6));
}

/** Step of a slider: the last digit of the number as written, and at most a hundredth of the width for non-integers. */
function stepFor(width: number, places: number): number {
	const lastDigit = 10 ** -places;
	if (places === 0 || !(width > 0)) return lastDigit;
	return Math.min(lastDigit, 10 ** Math.floor(Math.log10(width / 100)));
}

/** Returns the number of decimals of a number as written: of `0.50` 2, of `5e-3` 3. */
export function decimals(text: string): number {
	const [mantissa, exponent = "0"] = text.toLowerCase().split("e");
	return Math.max(0, (mantissa.split(".")[1]?.length ?? 0) - Number(exponent));
}

/** `(0.5,-1)`. */
const POINT = /\(([-−]?(?:\d+(?:\.\d*)?|\.\d+)),([-−]?(?:\d+(?:\.\d*)?|\.\d+))\)/g;

/** Returns the curve that a #curve line defines; none while its points are incomplete. */
function curveIn(line: readonly Token[]): Curve[] {
	const [head, name, ...rest] = line;
	const body = rest.filter(({ kind }) => kind !== "comment");
	if (body.length === 0) return [];
	const text = body.map((piece) => piece.text).join("");
	const points = [...text.matchAll(POINT)];
	if (points.length < 2 || points.map(([all]) => all).join("") !== text) return [];
	return [
		{
			name: name.text,
			line: head.line,
			from: body[0].from,
			to: body[body.length - 1].to,
			points: points.map(([, x, y]) => [Number(x), Number(y)] as const),
		},
	];
}

/**
 * Returns a number with the sign before it, unless that is an operator.
 * @param index of the number's token
 */
function signedNumber(pieces: readonly Token[], index: number): NumberAt {
	const { from, to, text } = pieces[index];
	const [before, sign] = [pieces[index - 2], pieces[index - 1]];
	const endsValue =
		!before || before.kind === "number" || before.kind === "name" || before.text === ")" || before.text === "]";
	// A sign after a constant's name belongs to its value.
	const hasOwnSign = sign?.text === "-" && sign.to === from && (!endsValue || isDefined(pieces, index - 2));
	const signedText = hasOwnSign ? `-${text}` : text;
	return { from: hasOwnSign ? sign.from : from, to, text: signedText, value: Number(signedText) };
}

/**
 * Returns whether a token is the name that a `#define` defines.
 * @param index of the token
 */
function isDefined(pieces: readonly Token[], index: number): boolean {
	return pieces[index - 1]?.text === "#define" && pieces[index].line === pieces[index - 1].line;
}

/** Returns the symbols of a text with their first parameter list, such as `A` → `A(x, y)`. */
function symbolsIn(pieces: readonly Token[], text: string): Map<string, string> {
	const symbols = new Map<string, string>();
	pieces.forEach(({ kind, text: name, to }, at) => {
		// A symbol listed first without parameters may have some later.
		if (kind !== "symbol" || (symbols.get(name) ?? name) !== name || !/^[\p{L}_?]/u.test(name)) return;
		const close = pieces[at + 1]?.text === "(" ? endOfBrackets(pieces, at + 1) : undefined;
		symbols.set(name, close === undefined ? name : `${name}${text.slice(to, close)}`);
	});
	return symbols;
}

/**
 * Returns the position in the text behind the bracket that closes the one at a token; undefined if it is not closed.
 * @param open index of the token
 */
function endOfBrackets(pieces: readonly Token[], open: number): number | undefined {
	let depth = 0;
	for (let index = open; index < pieces.length; index++) {
		if (pieces[index].text === "(") depth++;
		if (pieces[index].text === ")" && --depth === 0) return pieces[index].to;
	}
	return undefined;
}
