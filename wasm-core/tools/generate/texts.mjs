/**
 * From the texts of wasm-core/grammars/<model>/, of a model whose presets are texts (kinds.json is in the same folder):
 * the list of its presets, their texts by name as a module of its own, which is loaded when one is grown, and a page of
 * docs. Each text begins with a comment that describes it; variants.json lists presets that share a text.
 */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join, parse } from "node:path";
import { coreFolder, repository } from "../repository.mjs";

const grammars = join(coreFolder, "grammars");

/** Whether a model's presets are its texts. */
export const isGrown = (model) => existsSync(join(grammars, model, "kinds.json"));

/** Whether a file holds a text: every file but the lists. */
const isText = (file) => !file.endsWith(".json");

const json = (path) => (existsSync(path) ? JSON.parse(readFileSync(path, "utf8")) : []);

/** The keys of a header. */
const KEYS = ["kind", "about", "source", "page", "set"];

/**
 * Returns the first comment of a text: a title, then lines `key: value`; a line without a key goes on with the one
 * before.
 * @throws Error where it is no such comment
 */
function headerOf(file, text) {
	const fail = (message) => {
		throw new Error(`${file}: ${message}`);
	};
	const [, comment] = /^\s*\/\*([\s\S]*?)\*\//.exec(text) ?? fail("begins with no comment that says what it is");
	const [title, ...lines] = comment.split("\n").map((line) => line.trim());
	if (!title) fail("its comment does not begin with a title");
	/** @type {Record<string, any>} */
	const header = { title };
	let last;
	for (const line of lines.filter(Boolean)) {
		const [, key, value] = /^([a-z]+):\s+(.*)$/.exec(line) ?? [];
		if (key !== undefined && !KEYS.includes(key)) fail(`its comment has a line ${key}, which means nothing`);
		if (key === undefined && last === undefined) fail(`“${line}” belongs to no key`);
		if (key !== undefined) header[key] = value;
		else header[last] += ` ${line}`;
		last = key ?? last;
	}
	return header;
}

/** Keys that only make presets: a shown text does not have them. */
const HIDDEN = ["kind", "set"];

/** Returns a text without the lines of its first comment, and their continuations, that only make presets. */
export function shownText(text) {
	const end = text.indexOf("*/");
	let isHidden = false;
	const lines = text
		.slice(0, end)
		.split("\n")
		.filter((line) => {
			const [, key] = /^\s*([a-z]+):\s/.exec(line) ?? [];
			if (key !== undefined) isHidden = HIDDEN.includes(key);
			return !isHidden || line.trim() === "";
		});
	return lines.join("\n") + text.slice(end);
}

/** Splits values by the keys of the model's table into parameters, which the core reads, and the look. */
function valuesOf(name, set, table) {
	const values = { parameters: {}, look: {} };
	for (const [key, value] of Object.entries(set)) {
		const entry = table.parameters.find((each) => each.key === key);
		if (!entry) throw new Error(`${name}: sets ${key}, which the table does not have`);
		values[entry.look ? "look" : "parameters"][key] = entry.kind === "colour" ? value : Number(value);
	}
	return values;
}

const settingsIn = (text = "") =>
	Object.fromEntries(
		text
			.split(/\s+/)
			.filter(Boolean)
			.map((each) => each.split("=")),
	);

/** Returns the source of a text, and separately the number of its figure, which the gallery shows. */
function sourceOf({ source, page }) {
	if (source === undefined || source === "own text") return {};
	const [written, figure] = /,? figure (\d[\w.]*(?: [a-z](?![\w]))?)/.exec(source) ?? [];
	const book = (written ? source.replace(written, "") : source).replace(/\.$/, "");
	return { figure, source: `${book.charAt(0).toUpperCase()}${book.slice(1)}${page ? `, page ${page}` : ""}.` };
}

/**
 * Builds a preset from the header of its text and the settings of its variant.
 * @param set values by the keys of the model's table
 */
function presetOf(name, header, text, set, { kinds, table }) {
	const { title, kind, about, constants, details } = header;
	if (!/^[a-z0-9]+(-[a-z0-9]+)*$/.test(name)) throw new Error(`${name}: no lower-case name`);
	if (!kinds.some(({ key }) => key === kind)) throw new Error(`${name}: there is no kind ${kind} in kinds.json`);
	const { source, figure } = sourceOf(header);
	// In the order in which documents have them.
	const values = Object.entries(constants ?? {}).sort(([a], [b]) => (a < b ? -1 : 1));
	const own = { ...(values.length > 0 ? { constants: Object.fromEntries(values) } : {}), ...details };
	return {
		name,
		kind,
		title,
		since: 2,
		about: about ?? `${title}.`,
		...(source ? { source } : {}),
		...(figure ? { figure } : {}),
		...valuesOf(name, set, table),
		...(Object.keys(own).length > 0 ? { details: own } : {}),
		text,
	};
}

/** Presets in the order of their kinds, then of their names, and the texts by name. */
function read(model) {
	const folder = join(grammars, model);
	const kinds = json(join(folder, "kinds.json"));
	const table = json(join(coreFolder, "parameters", `${model}.json`));
	const files = new Map(
		readdirSync(folder)
			.filter(isText)
			.sort()
			.map((file) => [parse(file).name, file]),
	);
	const texts = new Map([...files].map(([name, file]) => [name, readFileSync(join(folder, file), "utf8")]));
	const variants = json(join(folder, "variants.json"));
	const presets = [...texts]
		.map(([name, text]) => ({ name, header: headerOf(`${model}/${files.get(name)}`, text) }))
		.filter(({ header }) => header.kind !== "none")
		.map(({ name, header }) => presetOf(name, header, name, settingsIn(header.set), { kinds, table }));
	for (const { name, text, set = {}, ...rest } of variants) {
		if (!texts.has(text)) throw new Error(`variants.json: ${name} is of the unknown text ${text}`);
		const shared = headerOf(text, texts.get(text));
		const header = { source: shared.source, page: shared.page, ...rest };
		presets.push(presetOf(name, header, text, { ...settingsIn(shared.set), ...set }, { kinds, table }));
	}
	const place = ({ kind }) => kinds.findIndex(({ key }) => key === kind);
	presets.sort((a, b) => place(a) - place(b));
	return { kinds: kinds.filter(({ key }) => presets.some(({ kind }) => kind === key)), presets, texts, files };
}

/** As a template, so that the text reads as it does in its file. */
const literal = (text) => `\`${text.replace(/[\\`]|\$\{/g, "\\$&")}\``;

const quoted = (name) => (/^[a-z]+$/.test(name) ? name : JSON.stringify(name));

/** Writes the TypeScript module with the list of the presets. */
function listOf({ kinds, presets }, notice) {
	return `${notice}
import type { Preset, PresetKind } from "../../specimen/presets";

/** A preset, and the name of the text that it grows from. */
export type TextPreset = Preset & { readonly text: string };

// biome-ignore format: a line each
export const PRESET_KINDS: readonly PresetKind[] = [
${kinds.map((kind) => `\t${JSON.stringify(kind)},`).join("\n")}
];

// biome-ignore format: a line each
export const PRESETS: readonly TextPreset[] = [
${presets.map((preset) => `\t${JSON.stringify(preset)},`).join("\n")}
];
`;
}

/** Writes the TypeScript module with the texts of the presets. */
function textsOf({ texts }, notice) {
	const entries = [...texts].map(([name, text]) => `\t${quoted(name)}: ${literal(shownText(text))},`);
	return `${notice}

/** The texts of presets by their names: loaded when the first is grown. */
export const TEXTS: Readonly<Record<string, string>> = {
${entries.join("\n")}
};
`;
}

const cell = (text) => String(text).replaceAll("|", "\\|");

/** Writes the page of docs: a table of presets for each kind. */
function pageOf(model, { kinds, presets, files }, notice) {
	// A model with its own language has the page about it in its own folder.
	const own = existsSync(join(repository, `docs/models/${model}/language.md`));
	const sections = kinds.map(({ key, title }) => {
		const rows = presets
			.filter(({ kind }) => kind === key)
			.map(
				({ name, title: called, about, source = "", figure, text }) =>
					`| \`${name}\` | ${cell(called)} | ${cell(about)} | ${cell(figure ? `${source} Figure ${figure}.` : source)} | [${files.get(text)}](../../../wasm-core/grammars/${model}/${files.get(text)}) |`,
			);
		return `## ${title}\n\n| preset | title | description | source | text |\n|---|---|---|---|---|\n${rows.join("\n")}\n`;
	});
	return `<!-- ${notice.replace(/^\/\/ /, "")} -->

# Presets of the model ${model}

The model [${model}](${model}.md) has ${presets.length} presets. Each of them is written in [${own ? "its language](language.md" : "the language](../../language.md"}).

${sections.join("\n")}`;
}

/** Returns the generated files. */
export function outputs() {
	return readdirSync(grammars)
		.filter(isGrown)
		.sort()
		.flatMap((model) => {
			const found = read(model);
			const notice = `// Made from wasm-core/grammars/${model} by wasm-core/tools/generate.mjs; edit the texts, not this.`;
			return [
				{ path: `web/src/models/${model}/presets.generated.ts`, text: listOf(found, notice) },
				{ path: `web/src/models/${model}/texts.generated.ts`, text: textsOf(found, notice) },
				{ path: `docs/models/${model}/presets.md`, text: pageOf(model, found, notice) },
			];
		});
}
