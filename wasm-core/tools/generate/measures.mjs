/**
 * From wasm-core/parameters/<model>.measures.json: that model's C++ list, its TypeScript table and its page of docs.
 */
import { namespaceOf, noticeOf, tablesOf } from "./tables.mjs";

/** Returns the generated files. */
export function outputs() {
	return tablesOf(".measures.json").flatMap(({ model, source, table }) => {
		checkMeasures(table, source);
		const notice = noticeOf(source);
		return [
			{
				path: `wasm-core/src/models/${model}/measures/measures.generated.hpp`,
				text: cplusplus(table, notice),
			},
			{ path: `web/src/models/${model}/measures.generated.ts`, text: typescript(table, notice) },
			{ path: `docs/models/${model}/measures.md`, text: markdown(table, notice) },
		];
	});
}

const kinds = ["number", "share", "whole", "note"];
const required = ["key", "label", "group", "kind", "unit", "decimals", "help", "source"];

function problemsOfClasses(classes) {
	const problems = [];
	const limits = classes.map(({ at, from }) => at ?? from);
	const sort = new Set(classes.map((one) => (one.at === undefined ? "from" : "at")));
	if (classes.some((one) => (one.at === undefined) === (one.from === undefined)) || sort.size > 1)
		problems.push("has classes that are not all `at` or all `from`");
	if (limits.some((limit, i) => i > 0 && !(limit > limits[i - 1]))) problems.push("has classes out of order");
	return problems;
}

function problemsOf(measure, groups) {
	const problems = required.filter((field) => measure[field] === undefined).map((field) => `has no ${field}`);
	if (!/^[a-z][a-z0-9_]*$/.test(measure.key ?? "")) problems.push("has a key that is no lower-case name");
	if (!groups.has(measure.group)) problems.push(`is of the unknown group ${measure.group}`);
	if (!kinds.includes(measure.kind)) problems.push(`is of the unknown kind ${measure.kind}`);
	if (measure.kind === "note" && !measure.classes) problems.push("is a note without classes");
	if (!/^[A-Z].*\.$/.test(measure.help ?? "")) problems.push("has help that is no sentence");
	return [...problems, ...problemsOfClasses(measure.classes ?? [])];
}

/** Throws with every problem of `table`, which was read from `from`. */
export function checkMeasures(table, from) {
	const groups = new Set(table.groups.map((group) => group.key));
	const problems = table.measures.flatMap((m) => problemsOf(m, groups).map((problem) => `${m.key} ${problem}`));
	const keys = table.measures.map(({ key }) => key);
	problems.push(...keys.filter((key, i) => keys.indexOf(key) !== i).map((key) => `${key} stands in it twice`));
	if (problems.length > 0) throw new Error(`${from}: ${problems.join("; ")}`);
}

/** Writes the C++ header: an enumeration of the measures and their number. */
function cplusplus(table, notice) {
	const { measures } = table;
	return `// ${notice}
#pragma once

#include <cstdint>

namespace panicle::${namespaceOf(table)} {

// In the order of Plant::measures; docs/models/${table.model}/measures.md has their units.
enum class Measure : std::uint32_t {
${measures.map(({ key }) => `  ${key},`).join("\n")}
};

inline constexpr std::uint32_t measure_count = ${measures.length};

}  // namespace panicle::${namespaceOf(table)}
`;
}

const literal = (value) => (Array.isArray(value) ? `[${value.map(literal).join(", ")}]` : JSON.stringify(value));
const line = (properties) =>
	`{ ${Object.entries(properties)
		.filter(([, value]) => value !== undefined)
		.map(([key, value]) => `${key}: ${literal(value)}`)
		.join(", ")} }`;

/**
 * Writes an object literal in the formatter's style: one property per line, and one class per line.
 * @param {any} measure with classes or without
 */
function object({ classes, ...properties }, indent) {
	const tabs = "\t".repeat(indent);
	const pairs = Object.entries(properties).map(([key, value]) => `${key}: ${literal(value)},`);
	if (classes) pairs.push(`classes: [\n${classes.map((one) => `${tabs}\t\t${line(one)},\n`).join("")}${tabs}\t],`);
	return `{\n${pairs.map((pair) => `${tabs}\t${pair}\n`).join("")}${tabs}}`;
}

/** Their keys in one line where they fit, as the formatter has it. */
function keysOf(measures) {
	const keys = measures.map(({ key }) => `"${key}"`);
	const line = `[${keys.join(", ")}]`;
	const [before, behind] = ["export const MEASURE_KEYS = ", " as const;"];
	if (before.length + line.length + behind.length <= 120) return line;
	return `[\n${keys.map((key) => `\t${key},\n`).join("")}]`;
}

/** Writes the TypeScript module: keys, descriptions and groups of the measures. */
function typescript({ groups, measures, skin }, notice) {
	return `// ${notice}
import type { MeasureGroup, MeasureInfo } from "../../specimen/measures";

/** Keys of the measures, in the order in which the core gives them. */
export const MEASURE_KEYS = ${keysOf(measures)} as const;
export type MeasureKey = (typeof MEASURE_KEYS)[number];

/** Every measure, in the same order. */
export const MEASURES: readonly MeasureInfo[] = [
${measures.map(({ source, ...measure }) => `\t${object(measure, 1)},\n`).join("")}];

/** The groups that panels and pages show, in order. */
export const MEASURE_GROUPS: readonly MeasureGroup[] = [
${groups.map((group) => `\t${line(group)},\n`).join("")}];
${skin ? ofLook(skin) : ""}`;
}

const ofLook = (skin) => `
/** The descriptor of skin colour, which is of the look and not measured by the core. */
export const SKIN_COLOUR = ${object(skin, 0)} as const;
`;

const cell = (text) => String(text).replaceAll("|", "\\|");

function classText({ note, at, words }, kind) {
	if (kind === "note" || at === note) return `${note} ${words}`;
	return at === undefined ? `${note} ${words}` : `${note} ${words} (${at})`;
}

function row(measure) {
	const classes = measure.classes?.map((one) => classText(one, measure.kind)).join(", ");
	const mark = measure.unchecked ? ` *(${measure.unchecked} unchecked)*` : "";
	const unit = measure.kind === "share" ? "0 … 1" : measure.unit;
	const cells = [`\`${measure.key}\``, measure.label, unit, measure.help, `${classes ?? ""}${mark}`, measure.source];
	return `| ${cells.map(cell).join(" | ")} |`;
}

/** Writes the page of docs: a table of measures for each group. */
function markdown({ noun, groups, measures, skin, remarks }, notice) {
	const head = "| key | name | unit | meaning | classes | source |\n|---|---|---|---|---|---|";
	const sections = groups.map((group) => {
		const rows = measures.filter((measure) => measure.group === group.key).map(row);
		return `## ${group.title}\n\n${head}\n${rows.join("\n")}\n`;
	});
	if (skin) sections.push(`## Appearance\n\n${head}\n${row({ ...skin, kind: "note", unit: "" })}\n`);
	return `<!-- ${notice} -->

# Measures of a ${noun}

Panicle measures every ${noun} that it grows. The app shows the measures under *Numbers*.
On the command line and in the JSON, use the name in the column *key*. If a measure does not apply to a plant, its value
in the JSON is \`null\`.

${remarks}

${sections.join("\n")}`;
}
