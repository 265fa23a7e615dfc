/** Names of types of web/src: those that hide a global of the browser or the language, and those that two folders export. */
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { sources } from "./words.mjs";

const repository = fileURLToPath(new URL("../..", import.meta.url));
const DECLARED =
	/^(?:export )?(?:declare )?(?:abstract )?(?:interface|type|class|enum|const|let|(?:async )?function) (\w+)/gm;
const EXPORTED_TYPE = /^export (?:declare )?(?:abstract )?(?:interface|type|class|enum) (\w+)/gm;

/** Names that are declared globally by TypeScript's libraries for browsers and the language. */
export function globals() {
	const typescript = createRequire(import.meta.url).resolve("typescript/package.json");
	const platform = `@typescript/typescript-${process.platform}-${process.arch}/package.json`;
	const library = dirname(createRequire(typescript).resolve(platform));
	const texts = ["dom", "es5"].map((name) => readFileSync(join(library, `lib/lib.${name}.d.ts`), "utf8"));
	return new Set(
		texts.flatMap((text) => [...text.matchAll(/^declare (?:var|function|const) (\w+)/gm)].map(([, name]) => name)),
	);
}

/** Names of a module's own declarations that hide a global. */
export const shadowsIn = (text, known) =>
	[...text.matchAll(DECLARED)].map(([, name]) => name).filter((name) => known.has(name));

/** The folder of a file of web/src that arrows are drawn for: `formats`, `models/leaf`. */
export const folderOf = (file) => /^web\/src\/(models\/[^/]+(?=\/)|[^/]+)/.exec(file)?.[1] ?? "";

/** Every declaration in web/src that hides a global, as `file: name`. */
export function shadows() {
	const known = globals();
	return sources(["web/src"]).flatMap((file) =>
		shadowsIn(readFileSync(join(repository, file), "utf8"), known).map((name) => `${file}: ${name}`),
	);
}

/**
 * Types that more than one folder of web/src exports, as `name: folder, folder`. The library is left out: its exports are the
 * public names of the package, some of them over types of the same name.
 */
export function repeatedTypes(
	texts = sources(["web/src"]).map((file) => [file, readFileSync(join(repository, file), "utf8")]),
) {
	const folders = new Map();
	for (const [file, text] of texts.filter(([file]) => folderOf(file) !== "library"))
		for (const [, name] of text.matchAll(EXPORTED_TYPE))
			folders.set(name, (folders.get(name) ?? new Set()).add(folderOf(file)));
	return [...folders]
		.filter(([, places]) => places.size > 1)
		.map(([name, places]) => `${name}: ${[...places].sort().join(", ")}`)
		.sort();
}
