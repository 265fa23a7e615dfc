/**
 * The user guides are consistent: link targets exist and links to plants grow. Their examples run in
 * tests/e2e/docs.spec.ts.
 */
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { dirname, join, relative } from "node:path";
import { describe, expect, it } from "vitest";
import { filesIn } from "../../wasm-core/tools/fresh.mjs";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { grow } from "../web/cli/world";
import { examplesOf, LANGUAGES, linksOf, pages, patternOf, plainly, textOf } from "./examples";
import { anchorsOf, targetsOf } from "./markdown";

/** Examples that take a program which tests do not have: an engine, a cluster. */
const NOT_RUN = 2;

const read = (file: string) => readFileSync(join(repository, file), "utf8");
const isThere = (file: string) => existsSync(join(repository, file));

describe.each(pages())("docs/%s.md", (page) => {
	const text = textOf(page);

	it("has examples, all in languages that are run and in fences", () => {
		const examples = examplesOf(text);
		const run = examples.filter(({ how }) => how !== "not-run");
		expect(run.length).toBeGreaterThanOrEqual(3);
		expect(run.filter(({ language }) => !(LANGUAGES as readonly string[]).includes(language))).toEqual([]);
		expect(run.filter(({ language, title }) => language !== "sh" && !title)).toEqual([]);
		const unfenced = text.replace(/^```[\s\S]*?^```$/gm, "");
		expect(unfenced.split("\n").filter((line) => /^( {4}|\t)/.test(line))).toEqual([]);
	});

	it("has a picture, and stands in the README", () => {
		expect(text).toMatch(/^!\[[^\]]{20,}\]\(people\/[\w-]+\.jpg\)$/m);
		expect(read("README.md")).toContain(`(docs/${page}.md)`);
	});

	it("has links that grow without a note", async () => {
		const links = linksOf(text);
		expect(links.length).toBeGreaterThan(0);
		for (const link of links) {
			const { status, json, messages } = await grow([link]);
			expect([link, status, messages, json?.notes]).toEqual([link, 0, [], []]);
		}
	});
});

it("there is a page for each who uses it, and few examples are not run", () => {
	expect(pages()).toEqual(["for-artists", "for-game-developers", "for-researchers", "for-teachers", "for-web-authors"]);
	const left = pages().flatMap((page) => examplesOf(textOf(page)).filter(({ how }) => how === "not-run"));
	expect(left.length).toBeLessThanOrEqual(NOT_RUN);
});

it("every page leads to files and headings that are there", () => {
	const atRoot = readdirSync(repository).filter((name) => name.endsWith(".md"));
	const below = filesIn("docs").map((file) => relative(repository, file));
	const files = [...atRoot, ...below].filter((file) => file.endsWith(".md"));
	expect(files.length).toBeGreaterThan(40);
	const broken = files.filter(isThere).flatMap((name) => {
		return targetsOf(read(name)).flatMap(({ path, anchor }) => {
			const target = path ? join(dirname(name), decodeURI(path)) : name;
			if (!isThere(target)) return [`${name}: ${path}`];
			const known = !anchor || !target.endsWith(".md") || anchorsOf(read(target)).has(decodeURI(anchor));
			return known ? [] : [`${name}: ${path}#${anchor}`];
		});
	});
	expect(broken).toEqual([]);
});

describe("reading a page", () => {
	it("takes examples with what they print, and refuses a text that nothing prints", () => {
		const page = 'Words.\n\n```sh\na\n```\n\nIt prints\n\n```text\nb\n```\n\n```js title="c.mjs" not-run\nd\n```\n';
		expect(examplesOf(page)).toEqual([
			{ language: "sh", title: undefined, code: "a\n", prints: "b\n", how: "run", line: 3 },
			{ language: "js", title: "c.mjs", code: "d\n", prints: undefined, how: "not-run", line: 13 },
		]);
		expect(() => examplesOf("```text\nb\n```\n")).toThrow("Line 1");
		expect(() => examplesOf(`${page}\n\`\`\`text\ne\n\`\`\`\n\`\`\`text\nf\n\`\`\`\n`)).toThrow("Line 20");
	});

	it("compares what is printed to the letter but for …", () => {
		const pattern = patternOf("a.b … c\n…\nend\n");
		const matches = ["a.b 12 c\nend", "a.b 12 c\nmore\nand more\nend", "a-b 12 c\n\nend", "a.b 12 c\n\nend."].map(
			(text) => pattern.test(plainly(`${text}  \n\n`)),
		);
		expect(matches).toEqual([false, true, false, false]);
		expect(patternOf("x …").test("x 1\n2")).toBe(false);
	});

	it("finds links as they are written in text and in HTML", () => {
		expect(linksOf('`?v=2&preset=a` [b](https://c.example/?v=2&seed=1) "?v=2&amp;seed=2" ?v=2&…')).toEqual([
			"?v=2&preset=a",
			"?v=2&seed=1",
			"?v=2&seed=2",
		]);
	});

	it("makes anchors as GitHub does, and takes nothing in code for a link", () => {
		expect([...anchorsOf("# A link’s `v`\n## B & c\n```sh\n# d\n```\n## B & c\n")]).toEqual([
			"a-links-v",
			"b--c",
			"b--c-1",
		]);
		expect(targetsOf('[a](b.md#c) `[d](e)` ![f](g.jpg "l") [h](https://i.example) [j](#k) <img src="m.webp">')).toEqual(
			[
				{ path: "b.md", anchor: "c" },
				{ path: "g.jpg", anchor: "" },
				{ path: "", anchor: "k" },
				{ path: "m.webp", anchor: "" },
			],
		);
	});
});
