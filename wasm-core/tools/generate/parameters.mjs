/** From wasm-core/parameters/<model>.json: that model's C++ table, its TypeScript table and its page of docs. */
import { checkTable } from "./check_table.mjs";
import { namespaceOf, noticeOf, tablesOf } from "./tables.mjs";

/** Returns the generated files. */
export function outputs() {
	return tablesOf(".json").flatMap(({ model, source, table }) => {
		checkTable(table, source);
		const notice = noticeOf(source);
		return [
			{ path: `wasm-core/src/models/${model}/parameters.generated.hpp`, text: cplusplus(table, notice) },
			{ path: `web/src/models/${model}/parameters.generated.ts`, text: typescript(table, notice) },
			{ path: `docs/models/${model}/parameters.md`, text: markdown(table, notice) },
		];
	});
}

/** Parameters that the core reads, in the request's order. */
const ofCore = (table) => table.parameters.filter((parameter) => !parameter.look);

/** A choice's number is the place of its option. */
const bounds = (p) => (p.kind === "choice" ? { min: 0, max: p.options.length - 1 } : { min: p.min, max: p.max });

const float = (value) => (Number.isInteger(value) ? `${value}.0f` : `${value}f`);

/** Writes the C++ table of the symbols' roles; `roles` are its finished rows. */
const rolesOf = (roles) => `// What symbols draw where a grammar declares no roles.
struct RoleInfo {
  std::string_view role;
  std::string_view symbol;
  bool begins;  // whether it is the symbol's beginning only
};

inline constexpr std::array<RoleInfo, ${roles.length}> role_table = {{
${roles.join("\n")}
}};

`;

/** Writes the C++ header: an enumeration of the parameters that the core reads, and the table of their limits. */
function cplusplus(table, notice) {
	const rows = ofCore(table);
	const entries = rows.map(
		(p) =>
			`    {"${p.key}", "${p.define ?? ""}", "${Object.values(p.where ?? {})[0] ?? ""}", ${[bounds(p).min, bounds(p).max, p.gapBelow ?? 0, p.default].map(float).join(", ")}, ${p.kind !== "number"}},`,
	);
	const roles = Object.entries(table.roles ?? {}).map(
		([role, symbol]) => `    {"${role}", "${symbol.replace(/\*$/, "")}", ${symbol.endsWith("*")}},`,
	);
	return `// ${notice}
#pragma once

#include <array>
#include <cstdint>
${roles.length > 0 ? "#include <string_view>\n" : ""}
#include "protocol/parameter_info.hpp"

namespace panicle::${namespaceOf(table)} {

// In the order of the request's words.
enum class Parameter : std::uint32_t {
${rows.map((p) => `  ${p.key},`).join("\n")}
};

inline constexpr std::uint32_t parameter_count = ${rows.length};

// clang-format off
inline constexpr std::array<ParameterInfo, parameter_count> parameter_table = {{
${entries.join("\n")}
}};
// clang-format on

${roles.length > 0 ? rolesOf(roles) : ""}}  // namespace panicle::${namespaceOf(table)}
`;
}

function literal(value) {
	if (Array.isArray(value)) return `[${value.map(literal).join(", ")}]`;
	if (typeof value !== "object" || value === null) return JSON.stringify(value);
	return `{ ${Object.entries(value)
		.map(([key, each]) => `${key}: ${literal(each)}`)
		.join(", ")} }`;
}

const fits = (line, indent) => 2 * indent + line.length <= 120;

/** Writes a property on its own line; a long list in it has one item per line. */
function property([key, value], indent) {
	const tabs = "\t".repeat(indent);
	const line = `${key}: ${literal(value)},`;
	if (!Array.isArray(value) || fits(line, indent)) return `${tabs}${line}`;
	return [`${tabs}${key}: [`, ...value.map((each) => `${tabs}\t${literal(each)},`), `${tabs}],`].join("\n");
}

/** Writes an object literal in the formatter's style: on one line if it fits, else one property per line. */
function object(properties, indent) {
	const given = Object.entries(properties).filter(([, value]) => value !== undefined);
	const line = `{ ${given.map(([key, value]) => `${key}: ${literal(value)}`).join(", ")} },`;
	if (fits(line, indent)) return `${"\t".repeat(indent)}${line}`;
	const inner = given.map((pair) => property(pair, indent + 1));
	return [`${"\t".repeat(indent)}{`, ...inner, `${"\t".repeat(indent)}},`].join("\n");
}

const fields = (
	"key link slot label symbol group basic kind unit options min max gapBelow default step " +
	"zero where help since before define look"
).split(" ");

function info(p) {
	const whole = p.kind === "choice" ? { unit: "", ...p, ...bounds(p), step: 1 } : p;
	return Object.fromEntries(fields.map((field) => [field, whole[field]]));
}

/** One line where it fits. */
function keyList(name, doc, parameters) {
	const line = `export const ${name} = [${parameters.map((p) => `"${p.key}"`).join(", ")}] as const;`;
	const lines = parameters.map((p) => `\t"${p.key}",\n`).join("");
	return `/** ${doc} */\n${line.length <= 120 ? line : `export const ${name} = [\n${lines}] as const;`}`;
}

/** `"a" | "b"`; where there are none, `never`. */
const union = (parameters) => parameters.map((p) => literal(p.key)).join(" | ") || "never";

/** Writes the TypeScript module: keys, descriptions and groups of the parameters. */
function typescript(table, notice) {
	const look = table.parameters.filter((p) => p.look);
	return `// ${notice}
import type { Group, ParameterEntry } from "../../specimen/table";

${keyList("NUMBER_KEYS", "Keys of the parameters that the core reads, in the request's order.", ofCore(table))}
export type NumberKey = (typeof NUMBER_KEYS)[number];

${keyList("LOOK_KEYS", "Keys of the parameters that only colour the result.", look)}
export type LookKey = (typeof LOOK_KEYS)[number];
/** Those of them that are colours, as six hexadecimal digits. */
export type ColourKey = ${union(look.filter((p) => p.kind === "colour"))};

/** Every parameter, in the order in which panels and pages show them. */
export const PARAMETERS: readonly ParameterEntry[] = [
${table.parameters.map((p) => object(info(p), 1)).join("\n")}
];

/** The groups that panels and pages show, in order. */
export const GROUPS: readonly Group[] = [
${table.groups.map((group) => object(group, 1)).join("\n")}
];
`;
}

const cell = (text) => String(text).replaceAll("|", "\\|");

function range(p) {
	if (p.kind === "colour") return "six hexadecimal digits";
	if (p.kind === "choice") return p.options.map((option) => `\`${option}\``).join(", ");
	const whole = p.kind === "integer" ? ", whole" : "";
	return p.gapBelow ? `0, or ${p.gapBelow} … ${p.max}${whole}` : `${p.min} … ${p.max}${whole}`;
}

function standardOf(p) {
	if (p.kind === "choice") return `\`${p.options[p.default]}\``;
	return p.kind === "colour" ? `\`${p.default}\`` : p.default;
}

/** Returns the options for which a parameter has an effect, for the page of docs. */
const conditionOf = ({ where = {} }) =>
	Object.entries(where)
		.map(([key, option]) => `\`${key}=${option}\``)
		.join(", ") || "all";

/** Writes a parameter's row of the page of docs. */
function row(p) {
	const link = p.slot === undefined ? `\`${p.link}\`` : `\`${p.link}\`, value ${p.slot + 1}`;
	const cells = [
		`\`${p.key}\``,
		p.symbol ? `${p.label} (${p.symbol})` : p.label,
		range(p),
		standardOf(p),
		p.unit ?? "",
		link,
		p.define ? `\`${p.define}\`` : "",
		conditionOf(p),
		p.help,
	];
	return `| ${cells.map(cell).join(" | ")} |`;
}

/** Writes the page of docs: a table of parameters for each group. */
function markdown(table, notice) {
	const sections = table.groups.map((group) => {
		const rows = table.parameters.filter((p) => p.group === group.key).map(row);
		const head =
			"| key | name | range | default | unit | in the link | in the grammar | used by | meaning |\n|---|---|---|---|---|---|---|---|---|";
		return `## ${group.title}\n\n${group.help}\n\n${head}\n${rows.join("\n")}\n`;
	});
	return `<!-- ${notice} -->

# Parameters of the ${table.noun}

You can change these parameters in the app, on the command line, in code, or in a link. The columns of the tables have
this meaning:

- *key*: the name of the parameter on the command line (\`--set KEY=VALUE\`) and in code
- *in the link*: the name of the parameter in the address bar
- *in the grammar*: the \`#define\` whose value the parameter replaces; a parameter with its default value replaces
  nothing
- *used by*: the options with which the parameter has an effect

${table.remarks}

${sections.join("\n")}`;
}
