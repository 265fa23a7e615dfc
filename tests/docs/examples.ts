/**
 * Examples in the user guides (docs/for-*.md): the words after a fence's language specify how to run the example, the
 * following ```` ```text ```` fence is its output.
 */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { repository } from "../../wasm-core/tools/repository.mjs";

/** Languages of examples. */
export const LANGUAGES = ["sh", "js", "html", "python"] as const;
type Language = (typeof LANGUAGES)[number];

export interface Example {
	/** Any other cannot be run. */
	readonly language: Language | (string & {});
	/** The file that it is, where its fence names one: `title="berries.py"`. */
	readonly title: string | undefined;
	readonly code: string;
	/** The expected output or page content; `…` matches varying parts. */
	readonly prints: string | undefined;
	/** `not-run`: it takes a program that tests do not have. `background`: it goes on while the others run. */
	readonly how: "run" | "not-run" | "background";
	/** Of its fence, from 1. */
	readonly line: number;
}

/** The pages, by their names without ending. */
export function pages(): string[] {
	return readdirSync(join(repository, "docs"))
		.filter((file) => /^for-.*\.md$/.test(file))
		.map((file) => file.slice(0, -".md".length));
}

export const textOf = (page: string): string => readFileSync(join(repository, `docs/${page}.md`), "utf8");

/** @throws Error where a page's fences cannot be meant */
export function examplesOf(text: string): Example[] {
	const examples: Example[] = [];
	for (const { 1: info, 2: code, index } of text.matchAll(/^```([^\n]*)\n([\s\S]*?)^```$/gm)) {
		const line = text.slice(0, index).split("\n").length;
		const [language, ...words] = info.split(" ");
		if (language === "text") {
			const last = examples.pop();
			if (!last || last.prints !== undefined) throw new Error(`Line ${line}: a text that no example prints.`);
			examples.push({ ...last, prints: code });
			continue;
		}
		const title = words.flatMap((word) => /^title="(.+)"$/.exec(word)?.[1] ?? [])[0];
		const how = (["not-run", "background"] as const).find((word) => words.includes(word)) ?? "run";
		examples.push({ language, title, code, prints: undefined, how, line });
	}
	return examples;
}

/** A pattern for the whole output: `…` matches anything within a line, a line of `…` any lines. */
export const patternOf = (prints: string): RegExp => new RegExp(`^${sourceOf(prints)}$`);

/** The same, of a part. */
export const partOf = (prints: string): RegExp => new RegExp(sourceOf(prints));

function sourceOf(prints: string): string {
	const lines = prints.trimEnd().split("\n");
	const patterns = lines.map((line) =>
		line.trim() === "…" ? "[\\s\\S]*?" : line.trimEnd().split("…").map(literally).join("[^\\n]*?"),
	);
	return patterns.join("\\n");
}

/** Output without spaces at ends of lines. */
export const plainly = (printed: string): string => printed.replace(/[ \t\r]+$/gm, "").trimEnd();

const literally = (text: string) => text.replace(/[.*+?^${}()|[\]\\/]/g, "\\$&");

/** Links of a page, from their `?` on; links with `…` are only illustrations and are omitted. */
export function linksOf(text: string): string[] {
	const all = [...text.matchAll(/\?v=\d[^\s"'`<>)\\]*/g)].map(([link]) => link.replaceAll("&amp;", "&"));
	return [...new Set(all)].filter((link) => !link.includes("…"));
}
