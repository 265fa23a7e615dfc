/**
 * From wasm-core/parameters/turtle.json: the compiler's and the interpreter's table, and the section of
 * docs/language.md.
 */
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { coreFolder, repository } from "../repository.mjs";
import { replaceSection } from "./section.mjs";

const source = "wasm-core/parameters/turtle.json";
const notice = `Made from ${source} by wasm-core/tools/generate.mjs; edit the table, not this.`;

/** The generated files. */
export function outputs() {
	const table = JSON.parse(readFileSync(join(coreFolder, "parameters/turtle.json"), "utf8"));
	check(table);
	return [
		{ path: "wasm-core/src/lsystem/turtle/turtle_symbols.generated.hpp", text: cplusplus(table) },
		...page(table),
	];
}

/** docs/language.md with the tables of symbols; none where the pages are not there. */
function page(table) {
	const path = "docs/language.md";
	const file = join(repository, path);
	if (!existsSync(file)) return [];
	return [{ path, text: replaceSection(readFileSync(file, "utf8"), "turtle", markdown(table)) }];
}

/** Checks the table. Throws an Error for one that the compiler of grammars could not use. */
function check({ categories, symbols }) {
	const fail = (message) => {
		throw new Error(`${source}: ${message}`);
	};
	const keys = new Set(categories.map((category) => category.key));
	const seen = new Set();
	for (const row of symbols) {
		if (!row.symbol || !row.name || !row.action || !row.help)
			fail(`${row.symbol}: symbol, name, action or help is missing.`);
		if (seen.has(row.symbol)) fail(`${row.symbol} stands in it twice.`);
		if (!keys.has(row.category)) fail(`${row.symbol}: there is no category ${row.category}.`);
		if (row.argument && !Number.isFinite(row.default)) fail(`${row.symbol}: its argument needs a default.`);
		seen.add(row.symbol);
	}
}

const literal = (value) => JSON.stringify(value);
const float = (value) => (Number.isInteger(value) ? `${value}.0f` : `${value}f`);
const mostArguments = (row) => (row.arguments === "any" ? "any_number" : (row.most ?? (row.argument ? 1 : 0)));
const setting = (row) => `Setting::${(row.setting ?? "none").replaceAll(" ", "_")}`;

/** Writes the C++ header: the actions, and the table of the turtle's symbols. */
function cplusplus({ symbols }) {
	const actions = [...new Set(symbols.map((row) => row.action))];
	const width = (field) => Math.max(...symbols.map((row) => literal(row[field]).length));
	const rows = symbols.map((row) => {
		const symbol = `${literal(row.symbol)},`.padEnd(width("symbol") + 1);
		const name = `${literal(row.name)},`.padEnd(width("name") + 1);
		const numbers = [
			float(row.default ?? 0),
			float(row.sign ?? 1),
			row.minimum === 0,
			setting(row),
			row.notation === "cpfg",
			row.yields === true,
		];
		return `    {${symbol} ${name} Action::${row.action}, ${mostArguments(row)}, ${numbers.join(", ")}},`;
	});
	return `// ${notice}
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace panicle::lsystem {

enum class Action : std::uint8_t {
${actions.map((action) => `  ${action},`).join("\n")}
};

// A default that a statement of the text sets for all modules, such as angle increment: 25.
enum class Setting : std::uint8_t { none, angle_increment, line_length, line_width, line_width_increment };

inline constexpr std::uint32_t any_number = 0xffffffffu;

struct TurtleSymbol {
  std::string_view symbol;
  std::string_view name;
  Action action;
  std::uint32_t max_arguments;
  float standard;     // the value of an argument that is left out
  float sign;         // the direction of the action
  bool non_negative;  // the argument may not be below 0
  Setting setting;    // the statement that sets this default
  bool cpfg_only;     // an ordinary symbol in the other notation
  bool yields;        // an ordinary symbol if a text in cpfg's notation rewrites it
};

// A turtle symbol's number in a derived string is its place here.
// clang-format off
inline constexpr std::array<TurtleSymbol, ${symbols.length}> turtle_symbols = {{
${rows.join("\n")}
}};
// clang-format on

}  // namespace panicle::lsystem
`;
}

const cell = (text) => String(text).replaceAll("|", "\\|");
const code = (text) => `\`${cell(text)}\``;

function written(row) {
	if (row.arguments === "any") return `${row.symbol}(…)`;
	if (row.arguments) return `${row.symbol}(${row.arguments})`;
	if (row.symbol === "~") return "~name(s)";
	return row.argument ? `${row.symbol}(${row.argument})` : row.symbol;
}

const name = (row) => (row.notation ? `${row.name} (cpfg only)` : row.name);

function standard(row) {
	if (!row.argument || row.action === "width" || row.action === "widen" || row.action.endsWith("_colour")) return "";
	return row.unit === "°" ? `${row.default}°` : row.default;
}

/** Writes the section of docs/language.md: a table of symbols for each category. */
function markdown({ categories, symbols }) {
	const sections = categories.map(({ key, title }) => {
		const rows = symbols
			.filter((row) => row.category === key)
			.map((row) => `| ${code(written(row))} | ${name(row)} | ${standard(row)} | ${cell(row.help)} |`);
		return `### ${title}\n\n| symbol | name | default | action |\n| --- | --- | --- | --- |\n${rows.join("\n")}\n`;
	});
	return `<!-- ${notice} -->

${sections.join("\n")}`;
}
