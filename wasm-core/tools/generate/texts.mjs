/**
 * From the texts of wasm-core/grammars/<model>/, of a model whose presets are texts (kinds.json stands with them): the list of its presets,
 * their texts by name as a module of its own, which is loaded when one is grown, and a page of docs. Each text begins with a
 * comment that says what it is; variants.json lists presets that share a text.
 */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { join, parse } from "node:path";
import { coreFolder, repository } from "../repository.mjs";

const grammars = join(coreFolder, "grammars");

/** Whether a model's presets are its texts. */
export const isGrown = (model) => existsSync(join(grammars, model, "kinds.json"));

/** What texts are called, whatever their language: everything there but the lists. */
const isText = (file) => !file.endsWith(".json");

const json = (path) => (existsSync(path) ? JSON.parse(readFileSync(path, "utf8")) : []);

/** What a header may say of its text. */
const KEYS = ["kind", "about", "source", "page", "set"];

/**
 * The first comment of a text: a title, then lines `key: value`; a line without a key goes on with the one before.
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

/** What of a header is for making presets alone: to whoever opens the text it would say nothing. */
const UNTOLD = ["kind", "set"];

/** A text as people read it: its first comment without those lines, and what goes on with them. */
export function shownText(text) {
	const end = text.indexOf("*/");
	let untold = false;
	const lines = text
		.slice(0, end)
		.split("\n")
		.filter((line) => {
			const [, key] = /^\s*([a-z]+):\s/.exec(line) ?? [];
			if (key !== undefined) untold = UNTOLD.includes(key);
			return !untold || line.trim() === "";
		});
	return lines.join("\n") + text.slice(end);
}

/** Values by the keys of the model's table, split into what the core reads and looks. */
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

/** Where a text is from, and the number of its figure apart, which the gallery shows. */
function sourceOf({ source, page }) {
	if (source === undefined || source === "own text") return {};
	const [told, figure] = /,? figure (\d[\w.]*(?: [a-z](?![\w]))?)/.exec(source) ?? [];
	const book = told ? source.replace(told, "") : source;
	return { figure, source: `${book.replace(/\.$/, "")}${page ? `, page ${page}` : ""}.` };
}

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
		about: [about, source].filter(Boolean).join(" ") || `${title}.`,
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

function pageOf(model, { kinds, presets, files }, notice) {
	// A language of its own has its page with the model's.
	const own = existsSync(join(repository, `docs/models/${model}/language.md`));
	const sections = kinds.map(({ key, title }) => {
		const rows = presets
			.filter(({ kind }) => kind === key)
			.map(
				({ name, title: called, about, figure, text }) =>
					`| \`${name}\` | ${cell(called)} | ${cell(figure ? `${about} Figure ${figure}.` : about)} | [${files.get(text)}](../../../wasm-core/grammars/${model}/${files.get(text)}) |`,
			);
		return `## ${title}\n\n| preset | title | what it is | text |\n|---|---|---|---|\n${rows.join("\n")}\n`;
	});
	return `<!-- ${notice.replace(/^\/\/ /, "")} -->

# Grammars

${presets.length} texts that grow as presets of the model [${model}](${model}.md), in the notation of [${own ? "its language](language.md" : "the language](../../language.md"}).

${sections.join("\n")}`;
}

/** The generated files. */
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
