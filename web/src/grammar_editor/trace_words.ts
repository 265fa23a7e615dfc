/** Describes modules of a derivation in plain words. */
import type { Chance, ModuleAnswer, TraceEntry } from "../plant/derivation_trace";
import { text } from "./messages.generated";

/** Returns a number of modules in words: "1,240 modules". */
export function countInWords(count: number): string {
	return text("modules", { count });
}

/** Returns a step in words: "Step 3 of 7", "Axiom". */
export function stepInWords(step: number, last: number): string {
	return step === 0 ? text("axiom") : text("step_of", { step, last });
}

/** Splits a module into its symbol and its parameters: `B`, `(29)`. */
export function partsOfModule(module: string): readonly [symbol: string, parameters: string] {
	const open = module.length > 1 ? module.indexOf("(", 1) : -1;
	return open < 0 ? [module, ""] : [module.slice(0, open), module.slice(open)];
}

/** Returns the values of a module's parameters: "n = 3, t = 0.5"; empty without any. */
export function valuesInWords({ values }: Pick<TraceEntry, "values">): string {
	return values.map(({ name, value }) => `${name} = ${value}`).join(", ");
}

/** "Random choice: probability 0.3 of 1 (drew 0.61)." */
export function chanceInWords({ total, weight, drawn }: Chance): string {
	return text("chance", { weight: short(weight), total: short(total), drawn: short(drawn) });
}

/** Describes a response of the environment, with its query if there is one: "Query: 0.1, 2. Response: 0.31, 1.". */
export function answerInWords({ asked, answered }: ModuleAnswer): string {
	const list = (numbers: readonly string[]) => (numbers.length > 0 ? numbers.join(", ") : text("nothing"));
	return asked
		? text("queried", { query: list(asked), answer: list(answered) })
		: text("received", { answer: list(answered) });
}

/** Splits a response into plain text and indices of modules of the same string, which it writes as #12. */
export function piecesOf(words: string): readonly (string | number)[] {
	return words.split(/#(\d+)/).map((piece, index) => (index % 2 === 1 ? Number(piece) : piece));
}

/** Describes the result of a module in the next step. */
export function fateOf(
	{ fires, children: { count } }: Pick<TraceEntry, "fires" | "children">,
	isLast: boolean,
): string {
	if (isLast) return text("ends");
	if (count === 0) return text(fires ? "disappears" : "pruned");
	if (!fires) return text("stays");
	return text("becomes", { count });
}

/** Describes a module in a few sentences, for screen readers. */
export function moduleInWords(module: TraceEntry, isLast: boolean): string {
	const { production, fires, answer, chance, refusals = [] } = module;
	const values = valuesInWords(module);
	const lineOf = (place: { readonly line: number }) => text("line", { line: String(place.line) });
	const when = isLast ? "drawn" : "next";
	return [
		production && text("written_by", { line: lineOf(production) }),
		fires &&
			(values
				? text("rewritten_with", { when, line: lineOf(fires), values })
				: text("rewritten", { when, line: lineOf(fires) })),
		fires && chance && chanceInWords(chance),
		answer && answerInWords(answer),
		answer?.words && describeAnswer(answer.words),
		fateOf(module, isLast),
		...refusals.map(({ production: refused, why }) => text("refused", { line: lineOf(refused), reason: why })),
	]
		.filter(Boolean)
		.join(" ");
}

/** Returns the reasons of a response with module numbers counted from 1. */
function describeAnswer(words: string): string {
	return piecesOf(words)
		.map((piece) => (typeof piece === "number" ? String(piece + 1) : piece))
		.join("");
}

/** Formats a number with at most three significant digits. */
const short = (value: number) => String(Number(value.toPrecision(3)));
