/** From wasm-core/parameters/turtle.json: the compiler's and the interpreter's table, and the page of docs. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { coreFolder } from "../repository.mjs";

const source = "wasm-core/parameters/turtle.json";
const notice = `Made from ${source} by wasm-core/tools/generate.mjs; edit the table, not this.`;

/** The generated files. */
export function outputs() {
	const table = JSON.parse(readFileSync(join(coreFolder, "parameters/turtle.json"), "utf8"));
	check(table);
	return [
		{ path: "wasm-core/src/lsystem/turtle/turtle_symbols.generated.hpp", text: cplusplus(table) },
		{ path: "docs/turtle.md", text: markdown(table) },
	];
}

/** Refuses a table that the compiler could not work with. */
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

// What a text says once for all its modules, in a line such as angle increment: 25.
enum class Setting : std::uint8_t { none, angle_increment, line_length, line_width, line_width_increment };

inline constexpr std::uint32_t any_number = 0xffffffffu;

struct TurtleSymbol {
  std::string_view symbol;
  std::string_view name;
  Action action;
  std::uint32_t most_arguments;
  float standard;     // stands in for an argument that is left out
  float sign;         // which way the action goes
  bool non_negative;  // the argument may not be below 0
  Setting setting;    // the line of the text that says what stands in for it
  bool cpfg_only;     // a symbol of the text's own in the other notation
  bool yields;        // a symbol of the text's own where a text of cpfg's notation rewrites it
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

function markdown({ categories, symbols }) {
	const sections = categories.map(({ key, title }) => {
		const rows = symbols
			.filter((row) => row.category === key)
			.map((row) => `| ${code(written(row))} | ${name(row)} | ${standard(row)} | ${cell(row.help)} |`);
		return `## ${title}\n\n| symbol | name | argument left out | what it does |\n| --- | --- | --- | --- |\n${rows.join("\n")}\n`;
	});
	return `<!-- ${notice} -->

# The turtle's symbols

Table 1 of Huang et al. (2013), and what cpfg and *The Algorithmic Beauty of Plants* have besides. The turtle has a position, a width, a
colour and three axes of unit length: heading, left and up, with heading × left = up. Every argument may be left out; where the table says
by what angle or length, a line of the text may say another (\`angle increment: 25\`, \`line length: 2\`). An argument that is not a finite number, or one below 0
of a radius, a width or a size, is an error.

Texts are of one of two notations, which turn the other way round: under \`#turtle cpfg\` + turns left, & pitches down and / rolls the right
side down, under \`#turtle huang\`, the paper's, + turns right, & pitches up and / rolls the left side down. Without such a line a bunch's text is the
paper's and a text of the model *grammar* is cpfg's. [language.md](language.md) says how symbols are put together.

${sections.join("\n")}`;
}
