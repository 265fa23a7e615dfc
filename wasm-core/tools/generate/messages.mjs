/**
 * From the catalogues of messages: of each room of the page (web/src/<room>/messages.json) its typed look-up, of each
 * room of the core (wasm-core/src/<room>/messages.json) the codes for C++, all messages of the core for the page and
 * the tests, and of each translation (web/src/locale/<language>.json) a module.
 */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { dirname, join, relative } from "node:path";
import { repository } from "../repository.mjs";
import { argumentsOf, readMessage } from "./icu.mjs";

const notice = (source) => `Generated from ${source} by \`npm run generate\`; do not edit.`;

/** Catalogues below a folder of sources: their rooms ("models/flower"), paths and messages. */
function cataloguesIn(top) {
	if (!existsSync(join(repository, top))) return [];
	return readdirSync(join(repository, top), { recursive: true, encoding: "utf8" })
		.map((path) => path.replaceAll("\\", "/"))
		.filter((path) => path === "messages.json" || path.endsWith("/messages.json"))
		.sort()
		.map((path) => {
			const source = `${top}/${path}`;
			return { room: dirname(path), source, messages: readCatalogue(source) };
		});
}

/** The catalogues of the page. */
export const pageCatalogues = () => cataloguesIn("web/src");
/** The catalogues of the core. */
export const coreCatalogues = () => cataloguesIn("wasm-core/src");

/** The room as a part of codes: "models.flower" of the page, "core.flower" of the core. */
export const pageRoomCode = (room) => room.replaceAll("/", ".");
export const coreRoomCode = (room) => `core.${room.replace(/^models\//, "").replaceAll("/", ".")}`;

/** Languages with a file of translations. */
export const translations = () =>
	(existsSync(join(repository, "web/src/locale")) ? readdirSync(join(repository, "web/src/locale")) : [])
		.filter((name) => /^[a-z]{2}\.json$/.test(name))
		.sort();

/** Reads and checks a catalogue: keys in lower case with underscores, messages that can be read. */
function readCatalogue(source) {
	const messages = JSON.parse(readFileSync(join(repository, source), "utf8"));
	for (const [key, message] of Object.entries(messages)) checkMessage(source, key, message);
	return messages;
}

/** Words that cannot name an argument, since messages become functions of their arguments. */
const RESERVED = new Set(
	"case class const default delete do else export for function if import in new return switch this typeof var void while with".split(
		" ",
	),
);

/**
 * Checks the key and the text of a message.
 * @throws Error with the catalogue's path and the message's key
 */
function checkMessage(source, key, message) {
	const fail = (problem) => {
		throw new Error(`${source}: ${key}: ${problem}`);
	};
	if (!/^[a-z][a-z0-9_]*$/.test(key)) fail("a key is a name in lower case with underscores");
	if (typeof message !== "string" || message === "") fail("a message is a text");
	if (/['`\\]/.test(message)) fail("write ’ for an apostrophe; no ` and no backslash");
	let parts = [];
	try {
		parts = readMessage(message);
	} catch (error) {
		fail(error.message);
	}
	const reserved = [...argumentsOf(parts).keys()].filter((name) => RESERVED.has(name));
	if (reserved.length > 0) fail(`${reserved.join(", ")} is a word of JavaScript and names no argument`);
}

const quoted = (text) => JSON.stringify(text);
const inTemplate = (text) => text.replaceAll("${", "\\${");

/** Returns the body of a template literal for the parts of a message. */
function template(parts) {
	return parts
		.map((part) => {
			if (typeof part === "string") return inTemplate(part);
			if (part.number !== undefined) return `\${show(${part.number})}`;
			if (!part.kind) return `\${show(${part.name})}`;
			const cases = Object.entries(part.cases).map(([label, list]) => `${quoted(label)}: \`${template(list)}\``);
			return `\${${part.kind === "plural" ? "plural" : "choose"}(${part.name}, { ${cases.join(", ")} })}`;
		})
		.join("");
}

/**
 * A message as TypeScript: a string, or a function of its arguments.
 * @param {string} message
 * @param {boolean} typed whether arguments have types; those of translations have none
 */
function compiled(message, typed) {
	const parts = readMessage(message);
	const args = [...argumentsOf(parts)];
	if (args.length === 0) return quoted(message);
	const names = args.map(([name]) => name).join(", ");
	const types = args.map(([name]) => `${name}: Value`).join("; ");
	return `({ ${names} }: ${typed ? `{ ${types} }` : "Arguments"}) => \`${template(parts)}\``;
}

/** Import of the functions that compiled messages call. */
function importOf(entries, from, more = []) {
	const text = entries.join("\n");
	const names = ["choose", "plural", "show"].filter((name) => text.includes(`${name}(`));
	const all = [...names, ...(/\bValue\b/.test(text) ? ["type Value"] : []), ...more];
	return all.length > 0 ? `import { ${all.join(", ")} } from "${from}";\n` : "";
}

/** Writes the module of a room of the page. */
function pageModule({ room, source, messages }) {
	const entries = Object.entries(messages).map(([key, message]) => `\t${key}: ${compiled(message, true)},`);
	const locale = relative(join("web/src", room), "web/src/locale").replaceAll("\\", "/");
	const at = locale.startsWith(".") ? locale : `./${locale}`;
	return {
		path: `web/src/${room}/messages.generated.ts`,
		text: `// ${notice(source)}
${importOf(entries, `${at}/format`)}import { textsOf } from "${at}/texts";

/** The texts of ${room}, by their keys in messages.json. */
export const text = textsOf("${pageRoomCode(room)}", {
${entries.join("\n")}
});
`,
	};
}

/**
 * Writes the module of a translation. Rooms of parameters, measures and presets hold plain texts; all others hold
 * messages.
 * @param name of the file: `de.json`
 */
function translationModule(name) {
	const source = `web/src/locale/${name}`;
	const rooms = JSON.parse(readFileSync(join(repository, source), "utf8"));
	const entries = Object.entries(rooms).map(([room, messages]) => {
		const isPlain = /^(parameters|measures|presets)\./.test(room);
		if (!isPlain) for (const [key, message] of Object.entries(messages)) checkMessage(source, key, message);
		const lines = Object.entries(messages).map(
			([key, message]) => `\t\t${quoted(key)}: ${isPlain ? quoted(message) : compiled(message, false)},`,
		);
		return `\t${quoted(room)}: {\n${lines.join("\n")}\n\t},`;
	});
	const hasArguments = entries.join("").includes(": Arguments)");
	return {
		path: source.replace(".json", ".generated.ts"),
		text: `// ${notice(source)}
import type { Catalogue } from "./catalogue";
${importOf(entries, "./format", hasArguments ? ["type Value"] : [])}${hasArguments ? "\ntype Arguments = Record<string, Value>;\n" : ""}
export const catalogue: Catalogue = {
${entries.join("\n")}
};
`,
	};
}

/** Namespace of a room's codes in C++: "lsystem", "growth". */
const namespaceOf = (room) => room.replace(/^models\//, "").replaceAll("/", "_");

/** Writes the C++ header of a room of the core: a code for each message, typed by the number of its arguments. */
function coreHeader({ room, source, messages }) {
	const lines = Object.entries(messages).map(([key, message]) => {
		const count = argumentsOf(readMessage(message)).size;
		return `// ${message}\ninline constexpr MessageCode<${count}> ${key}{"${coreRoomCode(room).slice("core.".length)}.${key}"};`;
	});
	return {
		path: `wasm-core/src/${room}/messages.generated.hpp`,
		text: `// ${notice(source)}
#pragma once

#include "foundation/message.hpp"

namespace panicle::messages::${namespaceOf(room)} {

${lines.join("\n")}

}  // namespace panicle::messages::${namespaceOf(room)}
`,
	};
}

/**
 * Generates the page's module with all messages of the core, by room and key, with the order of their arguments, which
 * the page inserts.
 */
function corePage(catalogues) {
	const rooms = catalogues.map(({ room, messages }) => {
		const lines = Object.entries(messages).map(([key, message]) => `\t\t${key}: ${compiled(message, false)},`);
		return `\t${quoted(coreRoomCode(room))}: {\n${lines.join("\n")}\n\t},`;
	});
	const names = catalogues.map(({ room, messages }) => {
		const lines = Object.entries(messages)
			.map(([key, message]) => [key, [...argumentsOf(readMessage(message)).keys()]])
			.filter(([, list]) => list.length > 0)
			.map(([key, list]) => `\t\t${key}: ${quoted(list)},`);
		return `\t${quoted(coreRoomCode(room))}: {\n${lines.join("\n")}\n\t},`;
	});
	return {
		path: "web/src/core/core_messages.generated.ts",
		text: `// ${notice("wasm-core/src/**/messages.json")}
${importOf(rooms, "../locale/format", ["type Value"])}
type Arguments = Record<string, Value>;

/** English messages of the core by room and key. */
export const CORE_MESSAGES: Readonly<Record<string, Readonly<Record<string, string | ((args: Arguments) => string)>>>> = {
${rooms.join("\n")}
};

/** Names of a message's arguments, in the order in which the core sends them. */
export const CORE_ARGUMENTS: Readonly<Record<string, Readonly<Record<string, readonly string[]>>>> = {
${names.join("\n")}
};
`,
	};
}

/** Generates the list of all messages of the core in English, for native tests and tools: code, arguments and text. */
function coreEnglish(catalogues) {
	const rows = catalogues.flatMap(({ room, messages }) =>
		Object.entries(messages).map(([key, message]) => {
			const code = `${coreRoomCode(room).slice("core.".length)}.${key}`;
			const names = [...argumentsOf(readMessage(message)).keys()].join(" ");
			return `    {${[code, names, message].map(quoted).join(", ")}},`;
		}),
	);
	return {
		path: "wasm-core/src/foundation/english.generated.hpp",
		text: `// ${notice("wasm-core/src/**/messages.json")}
#pragma once

namespace panicle {

// A message in English: its code, the names of its arguments in the order in which they are sent, and its text.
struct EnglishMessage {
  const char* code;
  const char* arguments;
  const char* text;
};

inline constexpr EnglishMessage english_messages[] = {
${rows.join("\n")}
};

}  // namespace panicle
`,
	};
}

/** The generated files. */
export function outputs() {
	const core = coreCatalogues();
	return [
		...pageCatalogues().map(pageModule),
		...translations().map(translationModule),
		...core.map(coreHeader),
		...(core.length > 0 ? [corePage(core), coreEnglish(core)] : []),
	];
}
