/**
 * The published grammars as `lindenmayer` from npm derives them. oracle.tsv has the number of modules of each step's string, a hash of
 * their symbols and a sum of their parameters; tests/core/lsystem/conformance_test.cpp compares the engine with it.
 * `npm test` derives strings of up to 1,000 modules, `npm run test:long` all that are recorded.
 * `UPDATE_GOLDENS=1 npx vitest run tests/golden/oracle` writes the file anew.
 */
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import LSystem, { type Part } from "lindenmayer";
import { expect, it } from "vitest";
import { inRun } from "../long_run.mjs";
import { evaluate, type Production, type Published, readPublished, type Written } from "./published";

const grammars = new URL("../../wasm-core/grammars/grammar/", import.meta.url);
const file = new URL("./oracle.tsv", import.meta.url);
/** The limits of recorded strings and derivations: steps beyond are left out. */
const MAX_SIZE = { modules: 8000, steps: 60 };
/** The longest strings that this run derives. */
const longest = process.env.UPDATE_GOLDENS ? MAX_SIZE.modules : inRun(1000, MAX_SIZE.modules);

/** FNV-1a of the symbols, a blank behind each. */
function hash(parts: readonly Part[]): number {
	let value = 0x811c9dc5;
	for (const byte of new TextEncoder().encode(parts.map(({ symbol }) => `${symbol} `).join("")))
		value = Math.imul(value ^ byte, 0x01000193) >>> 0;
	return value;
}

/** Parameters by their places, so that two changed about make a difference. */
function sum(parts: readonly Part[]): number {
	return parts.flatMap(({ params }) => params).reduce((total, value, i) => total + Math.abs(value) * (1 + (i % 7)), 0);
}

const made = (written: readonly Written[], names: ReadonlyMap<string, number>): Part[] =>
	written.map(({ symbol, args }) => ({ symbol, params: args.map((arg) => evaluate(arg, names)) }));

/** Where the library finds a context, as ends of branches bound it: to the right it looks beyond them itself. */
function neighbours(
	system: LSystem,
	{ ignored }: Published,
	index: number,
	written: readonly Written[],
	direction: "left" | "right",
) {
	const string = system.getRaw();
	const ignoredSymbols = [...new Set(string.map(({ symbol }) => symbol))].filter((symbol) => ignored(symbol));
	const match = written.map(({ symbol }) => symbol);
	const found = system.match({ direction, match, index, ignoredSymbols, branchSymbols: ["[", "]"] as never });
	const indices = direction === "left" ? found.matchIndices.reverse() : found.matchIndices;
	if (!found.result) return undefined;
	let depth = 0;
	for (let i = index + 1; direction === "right" && i <= (indices.at(-1) ?? 0); i++) {
		depth += string[i].symbol === "[" ? 1 : string[i].symbol === "]" ? -1 : 0;
		if (depth < 0) return undefined;
	}
	const parts = indices.map((i) => string[i]);
	return parts.every(({ params }, i) => params.length === written[i].args.length) ? parts : undefined;
}

function applied(system: LSystem, published: Published, at: { index: number; part: Part }, rule: Production) {
	if (rule.formals.length !== at.part.params.length) return undefined;
	const names = new Map(published.constants);
	for (const [i, name] of rule.formals.entries()) names.set(name.trim(), at.part.params[i]);
	for (const [side, written] of [
		["left", rule.left],
		["right", rule.right],
	] as const) {
		if (written.length === 0) continue;
		const parts = neighbours(system, published, at.index, written, side);
		if (!parts) return undefined;
		written.forEach(({ args }, n) => {
			for (const [i, name] of args.entries()) names.set(name.trim(), parts[n].params[i]);
		});
	}
	return evaluate(rule.condition, names) ? made(rule.successor, names) : undefined;
}

function* derived(published: Published) {
	const system = new LSystem({ axiom: made(published.axiom, published.constants), allowClassicSyntax: false });
	for (const symbol of new Set(published.productions.map((rule) => rule.symbol))) {
		const rules = published.productions.filter((rule) => rule.symbol === symbol);
		system.setProduction(symbol, (at) => {
			for (const rule of rules) {
				const successor = applied(system, published, at, rule);
				if (successor) return successor;
			}
			return at.part;
		});
	}
	for (let step = 0; step <= Math.min(published.steps, MAX_SIZE.steps); step++) {
		const string = system.getRaw();
		if (string.length > longest) return;
		yield `${step}\t${string.length}\t${hash(string)}\t${sum(string).toPrecision(7)}`;
		if (step < published.steps) system.iterate(1);
	}
}

/** The lines of each grammar before its first string that is too long for this run. */
function withoutLongStrings(lines: readonly string[]): string[] {
	const ended = new Set<string>();
	return lines.filter((line) => {
		const [name, , count] = line.split("\t");
		if (Number(count) > longest) ended.add(name);
		return !ended.has(name);
	});
}

it("derives the published grammars as oracle.tsv has them", () => {
	const lines: string[] = [];
	const names: string[] = [];
	for (const name of readdirSync(grammars)
		.filter((each) => each.endsWith(".lsys"))
		.sort()) {
		const text = readFileSync(new URL(name, grammars), "utf8");
		let published: Published;
		try {
			published = readPublished(text);
		} catch {
			continue;
		}
		names.push(name);
		for (const line of derived(published)) lines.push(`${name}\t${line}`);
	}
	expect(names.length).toBeGreaterThan(40);
	if (process.env.UPDATE_GOLDENS) writeFileSync(file, `${lines.join("\n")}\n`);
	const recorded = readFileSync(file, "utf8").trimEnd().split("\n");
	expect(lines).toEqual(withoutLongStrings(recorded));
});
