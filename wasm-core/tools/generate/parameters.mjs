/** From wasm-core/parameters/<model>.json: that model's C++ table, its TypeScript table and its page of docs. */
import { checkTable } from "./check_table.mjs";
import { namespaceOf, noticeOf, tablesOf } from "./tables.mjs";

/** The generated files. */
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
#include <string_view>

namespace panicle::${namespaceOf(table)} {

// In the order of the request's words.
enum class Parameter : std::uint32_t {
${rows.map((p) => `  ${p.key},`).join("\n")}
};

inline constexpr std::uint32_t parameter_count = ${rows.length};

struct ParameterInfo {
  std::string_view key;
  std::string_view define;  // the grammar's #define it replaces; empty for none
  std::string_view where;   // the option that must be chosen for it to be heeded; empty: always
  float min, max;
  float gap_below;  // values strictly between 0 and this are raised to it; 0 for none
  float standard;
  bool whole;
};

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

/** A property on a line of its own, or a list in it one item a line. */
function property([key, value], indent) {
	const tabs = "\t".repeat(indent);
	const line = `${key}: ${literal(value)},`;
	if (!Array.isArray(value) || fits(line, indent)) return `${tabs}${line}`;
	return [`${tabs}${key}: [`, ...value.map((each) => `${tabs}\t${literal(each)},`), `${tabs}],`].join("\n");
}

/** An object literal as the formatter lays it out: one line where it fits, else one property a line. */
function object(properties, indent) {
	const given = Object.entries(properties).filter(([, value]) => value !== undefined);
	const line = `{ ${given.map(([key, value]) => `${key}: ${literal(value)}`).join(", ")} },`;
	if (fits(line, indent)) return `${"\t".repeat(indent)}${line}`;
	const inner = given.map((pair) => property(pair, indent + 1));
	return [`${"\t".repeat(indent)}{`, ...inner, `${"\t".repeat(indent)}},`].join("\n");
}

const fields = (
	"key link slot label symbol group kind unit options min max gapBelow default step " +
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

/** Which specimens heed it. */
const heedingOf = ({ where = {} }) =>
	Object.entries(where)
		.map(([key, option]) => `\`${key}=${option}\``)
		.join(", ") || "all";

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
		heedingOf(p),
		p.help,
	];
	return `| ${cells.map(cell).join(" | ")} |`;
}

function markdown(table, notice) {
	const sections = table.groups.map((group) => {
		const rows = table.parameters.filter((p) => p.group === group.key).map(row);
		const head =
			"| key | name | range | default | unit | in the link | in the grammar | heeded by | meaning |\n|---|---|---|---|---|---|---|---|---|";
		return `## ${group.title}\n\n${group.help}\n\n${head}\n${rows.join("\n")}\n`;
	});
	return `<!-- ${notice} -->

# Parameters of the ${table.noun}

*Key* is what \`--set\` of \`npm run grow\` and the programming interfaces call it, *in the link* what the address bar does. *In the
grammar* names the \`#define\` that a value other than the default replaces. ${table.remarks}

${sections.join("\n")}`;
}
