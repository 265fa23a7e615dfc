/**
 * Finds words that this project does not use in identifiers and comments (CONTRIBUTING.md, "Plain language"), with a better word
 * for each. `node tests/language/words.mjs [FOLDER…]` lists them; tests/language/words.test.ts fails on those that words.allowed.json does not
 * list.
 */
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

const repository = fileURLToPath(new URL("../..", import.meta.url));

/** Words in identifiers, split at capitals and underscores, and in comments; with a replacement. */
const ANYWHERE = [
	[/^(ask|asks|asked|asking|unasked)$/, "request, query, require"],
	[/^(tell|tells|telling|told|untold)$/, "report, trace, state"],
	[/^(say|says|saying|said|unsaid)$/, "set, setting, message, state"],
	[/^(heed|heeds|heeded|heeding|unheeded)$/, "use, respect"],
	[/^(bear|bears|bearing|bearer|bearers|borne|bore)$/, "attach, attached, carry, parent"],
	[/^(lay|lays|laid|laying)$/, "build, place, arrange"],
	[/^(luck|lucky)$/, "random value, noise"],
	[/^(kept|unkept)$/, "cached, stored, retained"],
	[/^nobody$/, "none, invalid, no one"],
	[/^aside$/, "offscreen"],
	[/^(mend|mends|mended|mending)$/, "fix, repair"],
];
/** Phrases in comments. */
const IN_COMMENTS = [
	[/\bwhat\b/gi, "the noun itself"],
	[/\b(who|whoever|whatever)\b/gi, "the noun itself"],
	[/\bin passing\b/gi, "as a preview"],
	[/\bfor ever\b/gi, "permanently, frozen"],
	[/\bc[oa]mes? about\b/gi, "happen"],
	[/\bbroke off\b/gi, "failed"],
	[/\bgiv(?:e|es|en|ing) away\b/gi, "reveal"],
	[/\ba hand\b/gi, "the pointer, the user"],
];

/** Comments and code of a source text, line by line: strings and regular expressions are blanked. */
export function partsOf(text) {
	const comments = [];
	const code = [];
	const pattern =
		/\/\*[\s\S]*?\*\/|\/\/[^\n]*|R"([^(\s]*)\([\s\S]*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*'|`(?:\\[\s\S]|\$\{[^}]*\}|[^`\\])*`|(?<=[=(,:!&|?;{}]\s*|return\s+)\/(?![*/])(?:\\.|\[(?:\\.|[^\]\\\n])*\]|[^/\\\n[])+\/[a-z]*/g;
	let line = 1;
	let from = 0;
	const add = (list, piece) => {
		for (const [i, each] of piece.split("\n").entries()) if (each.trim()) list.push([line + i, each]);
		line += piece.split("\n").length - 1;
	};
	for (const match of text.matchAll(pattern)) {
		add(code, text.slice(from, match.index));
		const isComment = match[0].startsWith("//") || match[0].startsWith("/*");
		const inserted = match[0].startsWith("`") ? [...match[0].matchAll(/\$\{([^}]*)\}/g)].map(([, each]) => each) : [];
		for (const each of inserted) code.push([line, each]);
		add(isComment ? comments : [], match[0]);
		from = match.index + match[0].length;
	}
	add(code, text.slice(from));
	return { comments, code };
}

const partsOfName = (name) => name.split(/_|(?<=[a-z0-9])(?=[A-Z])/).map((part) => part.toLowerCase());

/**
 * Uses of avoided words in a source text.
 * @returns {{ line: number, word: string, found: string, better: string }[]} `found` is the identifier, or the word in a comment
 */
export function avoidedWords(text) {
	const { comments, code } = partsOf(text);
	const uses = [];
	for (const [line, each] of code)
		for (const [name] of each.matchAll(/[A-Za-z_][A-Za-z0-9_]*/g))
			for (const part of partsOfName(name))
				for (const [pattern, better] of ANYWHERE)
					if (pattern.test(part)) uses.push({ line, word: part, found: name, better });
	for (const [line, each] of comments) {
		for (const [word] of each.matchAll(/[A-Za-z]+/g))
			for (const [pattern, better] of ANYWHERE)
				if (pattern.test(word.toLowerCase())) uses.push({ line, word: word.toLowerCase(), found: word, better });
		for (const [pattern, better] of IN_COMMENTS)
			for (const [word] of each.matchAll(pattern)) uses.push({ line, word: word.toLowerCase(), found: word, better });
	}
	return uses;
}

/** Sources of the project below some folders. Generated files follow their generators. */
export function sources(folders = ["wasm-core/src", "web/src", "tests"]) {
	return execFileSync("git", ["ls-files", "--cached", "--others", "--exclude-standard", ...folders], {
		cwd: repository,
		encoding: "utf8",
	})
		.split("\n")
		.filter(
			(file) =>
				/\.(ts|mjs|cpp|hpp|h)$/.test(file) && !file.includes(".generated.") && !file.startsWith("tests/language/"),
		);
}

/** Every use below some folders, with its file. */
export const usesIn = (folders) =>
	sources(folders).flatMap((file) =>
		avoidedWords(readFileSync(join(repository, file), "utf8")).map((use) => ({ file, ...use })),
	);

if (process.argv[1] === fileURLToPath(import.meta.url)) {
	const folders = process.argv.slice(2);
	const uses = usesIn(folders.length > 0 ? folders : undefined);
	for (const { file, line, found, better } of uses) console.log(`${file}:${line}: ${found} → ${better}`);
	console.error(`${uses.length} uses`);
}
