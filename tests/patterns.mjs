/**
 * Finds regular expressions that may take time that grows faster than the text. A backtracking engine tries every way to match: two loops that
 * can consume the same characters, or a loop that every start position repeats, cost the square of the length and more.
 */
import { RegExpParser, visitRegExpAST } from "@eslint-community/regexpp";
import { Chars, getConsumedChars, isPotentiallyEmpty } from "regexp-ast-analysis";
import { analyse } from "scslre";
import { parseAst } from "vite";

/** @typedef {import("@eslint-community/regexpp").AST.Element} Element */
/** @typedef {import("@eslint-community/regexpp").AST.Flags} Flags */
/**
 * A regular expression of a source file; `built` if the program composes it at run time, so that it cannot be checked.
 * @typedef {{ line: number, text: string, source: string, flags: string, built: boolean }} Pattern
 */

/**
 * All regular expressions of a TypeScript source.
 * @param {string} code
 * @returns {Pattern[]}
 */
export function patternsIn(code) {
	const found = [];
	const walk = (node) => {
		if (Array.isArray(node)) for (const each of node) walk(each);
		if (typeof node !== "object" || node === null || Array.isArray(node)) return;
		const { type, regex, callee, start, end } = node;
		const built = /^(?:New|Call)Expression$/.test(type) && callee?.name === "RegExp";
		if (regex || built) {
			const line = code.slice(0, start).split("\n").length;
			const { pattern: source = "", flags = "" } = regex ?? {};
			found.push({ line, text: code.slice(start, end), source, flags, built });
		}
		for (const each of Object.values(node)) walk(each);
	};
	walk(parseAst(code, { lang: "ts" }).body);
	return found;
}

/**
 * The reason why a pattern may backtrack; undefined if its time is proportional to the length of the text.
 * @param {Pick<Pattern, "source" | "flags">} pattern
 * @returns {string | undefined}
 */
export function complaintOf({ source, flags }) {
	const literal = new RegExpParser({ ecmaVersion: 2024 }).parseLiteral(`/${source}/${flags}`);
	const [report] = analyse(literal, { reportTypes: { Move: !flags.includes("y") } }).reports;
	if (report)
		return `${report.type}${report.exponential ? ", exponential" : ""}: two loops can consume the same characters, or every start repeats a loop`;
	return restarts(literal)
		? "the loop can consume further beginnings of a match, and the end of the match may be missing"
		: undefined;
}

/** Whether a loop can consume further beginnings of a match, each of which repeats the loop: `/\*[^]*?\*\/` on many `/*`. */
function restarts({ pattern, flags }) {
	if (flags.sticky) return false;
	let found = false;
	visitRegExpAST(pattern, {
		onQuantifierEnter(loop) {
			if (loop.max !== Number.POSITIVE_INFINITY) return;
			const { chars } = getConsumedChars(loop, flags);
			const [before, after] = besides(loop);
			const needed = before.filter((each) => each.type === "Assertion" || !isPotentiallyEmpty(each, flags));
			const isAnchored = needed.some((each) => each.type === "Assertion" && each.kind === "start" && !flags.multiline);
			if (needed.length === 0 || isAnchored) return;
			const again = needed.every((each) => {
				if (each.type !== "Assertion") return !getConsumedChars(each, flags).chars.isDisjointWith(chars);
				return each.kind !== "start" || !Chars.lineTerminator(flags).isDisjointWith(chars);
			});
			if (again && !alwaysEnds(after, chars.isAll, flags)) found = true;
		},
	});
	return found;
}

/**
 * The elements before an element and behind it, inside its groups and outside.
 * @param {Element} element
 * @returns {[before: Element[], after: Element[]]}
 */
function besides(element) {
	const { parent } = element;
	if (parent.type === "Quantifier") return besides(parent);
	if (parent.type !== "Alternative") return [[], []];
	const at = parent.elements.indexOf(element);
	const [before, after] = [parent.elements.slice(0, at), parent.elements.slice(at + 1)];
	const outer = parent.parent.type === "Pattern" ? [[], []] : besides(parent.parent);
	return [
		[...outer[0], ...before],
		[...after, ...outer[1]],
	];
}

/**
 * Whether the rest of a pattern always matches behind a loop: it may be empty, or it accepts the end of the text and the loop reaches it.
 * @param {readonly Element[]} after
 * @param {boolean} reachesEnd
 * @param {Flags} flags
 * @returns {boolean}
 */
function alwaysEnds(after, reachesEnd, flags) {
	return after.every((each) => {
		if (each.type === "Assertion") return each.kind === "end" && !flags.multiline && reachesEnd;
		if (isPotentiallyEmpty(each, flags)) return true;
		const choices = each.type === "Group" || each.type === "CapturingGroup" ? each.alternatives : [];
		return choices.some(({ elements }) => elements.length > 0 && alwaysEnds(elements, reachesEnd, flags));
	});
}
