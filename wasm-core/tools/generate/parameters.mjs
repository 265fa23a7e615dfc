/** From wasm-core/parameters/bunch.json: the C++ table, the TypeScript table and the page of docs. */
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { coreFolder } from "../repository.mjs";
import { checkTable } from "./check_table.mjs";

const source = "wasm-core/parameters/bunch.json";
const notice = `Made from ${source} by wasm-core/tools/generate.mjs; edit the table, not this.`;

/** The generated files. */
export function outputs() {
	const table = JSON.parse(readFileSync(join(coreFolder, "parameters/bunch.json"), "utf8"));
	checkTable(table, source);
	return [
		{ path: "wasm-core/src/models/bunch/parameters.generated.hpp", text: cplusplus(table) },
		{ path: "web/src/models/bunch/parameters.generated.ts", text: typescript(table) },
		{ path: "docs/parameters.md", text: markdown(table) },
	];
}

/** Parameters that the core reads, in the request's order. */
const ofCore = (table) => table.parameters.filter((parameter) => !parameter.look);

/** A choice's number is the place of its option. */
const bounds = (p) => (p.kind === "choice" ? { min: 0, max: p.options.length - 1 } : { min: p.min, max: p.max });

const float = (value) => (Number.isInteger(value) ? `${value}.0f` : `${value}f`);

function cplusplus(table) {
	const rows = ofCore(table);
	const entries = rows.map(
		(p) =>
			`    {"${p.key}", "${p.define ?? ""}", "${p.procedure ?? ""}", ${[bounds(p).min, bounds(p).max, p.gapBelow ?? 0, p.default].map(float).join(", ")}, ${p.kind !== "number"}},`,
	);
	const roles = Object.entries(table.roles).map(
		([role, symbol]) => `    {"${role}", "${symbol.replace(/\*$/, "")}", ${symbol.endsWith("*")}},`,
	);
	return `// ${notice}
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace panicle::bunch {

// In the order of the request's words.
enum class Parameter : std::uint32_t {
${rows.map((p) => `  ${p.key},`).join("\n")}
};

inline constexpr std::uint32_t parameter_count = ${rows.length};

struct ParameterInfo {
  std::string_view key;
  std::string_view define;     // the grammar's #define it replaces; empty for none
  std::string_view procedure;  // the one that heeds it; empty where both do
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

// What symbols draw where a grammar declares no roles.
struct RoleInfo {
  std::string_view role;
  std::string_view symbol;
  bool begins;  // whether it is the symbol's beginning only
};

inline constexpr std::array<RoleInfo, ${roles.length}> role_table = {{
${roles.join("\n")}
}};

}  // namespace panicle::bunch
`;
}

const literal = (value) => (Array.isArray(value) ? `[${value.map(literal).join(", ")}]` : JSON.stringify(value));

/** An object literal as the formatter lays it out: one line where it fits, else one property a line. */
function object(properties, indent) {
	const pairs = Object.entries(properties)
		.filter(([, value]) => value !== undefined)
		.map(([key, value]) => `${key}: ${literal(value)}`);
	const line = `{ ${pairs.join(", ")} },`;
	const tabWidth = 2;
	if (indent * tabWidth + line.length <= 120) return `${"\t".repeat(indent)}${line}`;
	const inner = pairs.map((pair) => `${"\t".repeat(indent + 1)}${pair},`);
	return [`${"\t".repeat(indent)}{`, ...inner, `${"\t".repeat(indent)}},`].join("\n");
}

const fields = (
	"key link slot label symbol group kind unit options min max gapBelow default step " +
	"procedure help since before define look"
).split(" ");

function info(p) {
	const whole = p.kind === "choice" ? { unit: "", ...p, ...bounds(p), step: 1 } : p;
	return Object.fromEntries(fields.map((field) => [field, whole[field]]));
}

const keyList = (name, doc, parameters) =>
	`/** ${doc} */\nexport const ${name} = [\n${parameters.map((p) => `\t"${p.key}",\n`).join("")}] as const;`;

const shortKeyList = (name, doc, parameters) =>
	`/** ${doc} */\nexport const ${name} = [${parameters.map((p) => `"${p.key}"`).join(", ")}] as const;`;

function typescript(table) {
	return `// ${notice}

${keyList("NUMBER_KEYS", "Keys of the parameters that the core reads, in the request's order.", ofCore(table))}
export type NumberKey = (typeof NUMBER_KEYS)[number];

${shortKeyList(
	"LOOK_KEYS",
	"Keys of the parameters that only colour the result.",
	table.parameters.filter((p) => p.look),
)}
export type LookKey = (typeof LOOK_KEYS)[number];
/** Those of them that are colours, as six hexadecimal digits. */
export type ColourKey = ${table.parameters
		.filter((p) => p.kind === "colour")
		.map((p) => literal(p.key))
		.join(" | ")};

export type ParameterKey = NumberKey | LookKey;

/** One parameter: what it is called, what it may be, and where it stands in a link. */
export interface ParameterInfo {
	readonly key: ParameterKey;
	/** Key in the link, for ever. Parameters that share one are its comma-separated values, by \`slot\`. */
	readonly link: string;
	readonly slot?: number;
	readonly label: string;
	/** The paper's symbol, or empty. */
	readonly symbol: string;
	readonly group: string;
	readonly kind: "number" | "integer" | "choice" | "colour";
	readonly unit: string;
	/** A choice's values as links write them; its number is the place of one of them. */
	readonly options?: readonly string[];
	readonly min?: number;
	readonly max?: number;
	/** Values strictly between 0 and this are raised to it. */
	readonly gapBelow?: number;
	/** A number, or a colour as six hexadecimal digits. */
	readonly default: number | string;
	readonly step?: number;
	/** The one procedure that heeds it; absent where both do. */
	readonly procedure?: "paper" | "natural";
	readonly help: string;
	/** The link version that first knew it. */
	readonly since: number;
	/** What a link from before \`since\` means; the preset's value where absent. */
	readonly before?: number;
	/** The grammar's \`#define\` that it replaces. */
	readonly define?: string;
	/** Whether it only colours the result. */
	readonly look?: boolean;
}

/** Every parameter, in the order in which panels and pages show them. */
export const PARAMETERS: readonly ParameterInfo[] = [
${table.parameters.map((p) => object(info(p), 1)).join("\n")}
];

export interface GroupInfo {
	readonly key: string;
	readonly title: string;
	readonly help: string;
}

/** The groups that panels and pages show, in order. */
export const GROUPS: readonly GroupInfo[] = [
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
		p.procedure ?? "both",
		p.help,
	];
	return `| ${cells.map(cell).join(" | ")} |`;
}

function markdown(table) {
	const sections = table.groups.map((group) => {
		const rows = table.parameters.filter((p) => p.group === group.key).map(row);
		const head =
			"| key | name | range | default | unit | in the link | in the grammar | heeded by | meaning |\n|---|---|---|---|---|---|---|---|---|";
		return `## ${group.title}\n\n${group.help}\n\n${head}\n${rows.join("\n")}\n`;
	});
	return `<!-- ${notice} -->

# Parameters of the bunch

*Key* is what the custom \`--set\` of \`npm run grow\` and the programming interfaces call it, *in the link* what the address bar
does; to a link from before it was known it means what the preset says, but for \`procedure\`, which is \`paper\` there. *In the
grammar* names the \`#define\` that a value other than the default replaces. Units: px is a pixel of the paper's
600 × 600 view, u one unit of its grammars, of \`unit\` millimetres.

${sections.join("\n")}`;
}
