/**
 * Regular expressions whose time may grow faster than the text they are given. A backtracking engine tries every way to match: two loops
 * that can share characters out, or a loop that each start runs through again, cost the square of the length and more.
 */
import { RegExpParser, visitRegExpAST } from "@eslint-community/regexpp";
import { Chars, getConsumedChars, isPotentiallyEmpty } from "regexp-ast-analysis";
import { analyse } from "scslre";
import { parseAst } from "vite";

/** @typedef {import("@eslint-community/regexpp").AST.Element} Element */
/** @typedef {import("@eslint-community/regexpp").AST.Flags} Flags */
/**
 * A regular expression of a source file; `built` where it is put together as the program runs, so that nothing can be said of it.
 * @typedef {{ line: number, text: string, source: string, flags: string, built: boolean }} Pattern
 */

/**
 * All that a TypeScript source has.
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
 * Why a pattern may backtrack; undefined where its time grows with the length of the text alone.
 * @param {Pick<Pattern, "source" | "flags">} pattern
 * @returns {string | undefined}
 */
export function complaintOf({ source, flags }) {
	const literal = new RegExpParser({ ecmaVersion: 2024 }).parseLiteral(`/${source}/${flags}`);
	const [report] = analyse(literal, { reportTypes: { Move: !flags.includes("y") } }).reports;
	if (report)
		return `${report.type}${report.exponential ? ", exponential" : ""}: two loops share characters out, or each start runs one`;
	return restarts(literal) ? "what begins a match may stand in its loop again, and the end may be missing" : undefined;
}

/** Whether a loop behind a beginning can run over further beginnings, each of which runs it again: `/\*[^]*?\*\/` of many `/*`. */
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
 * What stands before an element and behind it, within its groups and outside them.
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
 * Whether what follows a loop is never missing: it may be empty, or the text's end will do and the loop reaches it.
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
