/** Describes modules of a derivation in plain words. */
import type { Chance, ModuleAnswer, TraceEntry } from "../plant/derivation_trace";

/** "1,240 modules". */
export function countInWords(count: number): string {
	return `${count.toLocaleString("en-GB")} module${count === 1 ? "" : "s"}`;
}

/** "Step 3 of 7", "Axiom". */
export function stepInWords(step: number, last: number): string {
	return step === 0 ? "Axiom" : `Step ${step} of ${last}`;
}

/** Splits a module into its symbol and its parameters: `B`, `(29)`. */
export function partsOfModule(text: string): readonly [symbol: string, parameters: string] {
	const at = text.length > 1 ? text.indexOf("(", 1) : -1;
	return at < 0 ? [text, ""] : [text.slice(0, at), text.slice(at)];
}

/** "n = 3, t = 0.5"; empty where there are none. */
export function valuesInWords({ values }: Pick<TraceEntry, "values">): string {
	return values.map(({ name, value }) => `${name} = ${value}`).join(", ");
}

/** "Drawn by 0.61 of 1: its weight is 0.33." */
export function chanceInWords({ total, weight, drawn }: Chance): string {
	return `by chance: ${short(weight)} of ${short(total)} is its weight, ${short(drawn)} was drawn`;
}

/** Describes a response of the environment, with its query if there is one: "Asked 0.1, 2 → answered 0.31, 1". */
export function answerInWords({ asked, answered }: ModuleAnswer): string {
	const list = (numbers: readonly string[]) => (numbers.length > 0 ? numbers.join(", ") : "nothing");
	return asked ? `Asked ${list(asked)} → answered ${list(answered)}` : `Was told ${list(answered)}`;
}

/** Splits a response into plain text and indices of modules of the same string. */
export function piecesOf(words: string): readonly (string | number)[] {
	const sentence = words.charAt(0).toUpperCase() + words.slice(1);
	return sentence.split(/\bmodule (\d+)/).map((piece, index) => (index % 2 === 1 ? Number(piece) : piece));
}

/** Describes the result of a module in the next step. */
export function fateOf(
	{ fires, children: { count } }: Pick<TraceEntry, "fires" | "children">,
	isLast: boolean,
): string {
	if (isLast) return "The derivation ends here.";
	if (count === 0) return fires ? "Nothing is left of it." : "It is cut.";
	if (!fires) return "It stays as it is.";
	return count === 1 ? "It becomes one module." : `It becomes ${count.toLocaleString("en-GB")} modules.`;
}

/** Describes a module in a few sentences, for screen readers. */
export function moduleInWords(module: TraceEntry, isLast: boolean): string {
	const { production, fires, answer, chance, refusals = [] } = module;
	const values = valuesInWords(module);
	const used = values ? ` with ${values}` : "";
	return [
		production ? `Written by the production in line ${production.line}.` : "",
		fires
			? `Rewritten ${isLast ? "where it is drawn" : "next"} by line ${fires.line}${used}${chance ? `, ${chanceInWords(chance)}` : ""}.`
			: "",
		answer ? `${answerInWords(answer)}.${answer.words ? ` ${describeAnswer(answer.words)}.` : ""}` : "",
		fateOf(module, isLast),
		...refusals.map(({ production: { line }, why }) => `Not line ${line}: ${why}.`),
	]
		.filter(Boolean)
		.join(" ");
}

/** Writes module numbers counted from 1. */
function describeAnswer(words: string): string {
	return piecesOf(words)
		.map((piece) => (typeof piece === "number" ? `module ${piece + 1}` : piece))
		.join("");
}

const short = (value: number) => String(Number(value.toPrecision(3)));
