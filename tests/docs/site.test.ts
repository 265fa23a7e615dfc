/** The documentation site: its navigation has every page, and its links are translated and checked. */
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, relative } from "node:path";
import { afterAll, describe, expect, it } from "vitest";
import { filesIn } from "../../wasm-core/tools/fresh.mjs";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { anchorMaker } from "../../wasm-core/tools/site/anchors.mjs";
import { brokenLinks } from "../../wasm-core/tools/site/check_links.mjs";
import { translate } from "../../wasm-core/tools/site/targets.mjs";
import sections from "../../web/docs_site/pages.json";
import { DEFAULT_MODEL, modelNamed, modelNames } from "../../web/src/models/index";

const pages = filesIn("docs")
	.map((file) => relative(join(repository, "docs"), file).replaceAll("\\", "/"))
	.filter((file) => file.endsWith(".md"));

it("lists every page of docs/ once in web/docs_site/pages.json; the wordmark leads to index.md", () => {
	const listed = sections.flatMap((section) => section.pages);
	expect(listed.sort()).toEqual(pages.filter((page) => page !== "index.md").sort());
});

describe("live plants", () => {
	const plants = pages.flatMap((page) => {
		const text = readFileSync(join(repository, "docs", page), "utf8").replace(/^```[\s\S]*?^```$/gm, "");
		return [...text.matchAll(/^<panicle-specimen ([^>]*)>$/gm)].map(([, attributes]) => {
			const { model = DEFAULT_MODEL, preset } = Object.fromEntries(
				[...attributes.matchAll(/([\w-]+)="([^"]*)"/g)].map(([, name, value]) => [name, value]),
			);
			return { page, model, preset, isLazy: attributes.includes('loading="lazy"') };
		});
	});

	it.each(plants)("$page: $preset is a preset of $model, and grows when it comes near the screen", async (plant) => {
		const { presets } = await modelNamed(plant.model);
		expect(presets.list.map(({ name }) => name)).toContain(plant.preset);
		expect(plant.isLazy).toBe(true);
	});

	it("are on a page of every model", () => {
		expect([...new Set(plants.map(({ model }) => model))].sort()).toEqual([...modelNames()].sort());
	});
});

describe("an address in docs/models/tree/tree.md", () => {
	const kinds: Readonly<Record<string, "file" | "folder" | "none">> = {
		"wasm-core/grammars": "folder",
		"docs/models/leaf/none.md": "none",
	};
	const onSite = (address: string) => translate(address, "docs/models/tree/tree.md", (path) => kinds[path] ?? "file");

	it.each([
		["https://nodejs.org/x.md", "https://nodejs.org/x.md"],
		["#light", "#light"],
		["../leaf/none.md", "../leaf/none.md"],
		["../leaf/likeness.svg", "../leaf/likeness.svg"],
		["../../../public/gallery/tree/oak-light.webp", "../../../gallery/tree/oak-light.webp"],
	])("%s is %s on the site", (address, expected) => {
		expect(onSite(address)).toEqual({ address: expected });
	});

	it("leads to a page, with its heading", () => {
		const expected = { address: "../../sky.html#light", page: "docs/sky.md" };
		expect(onSite("../../sky.md#light")).toEqual(expected);
	});

	it("leads to a copy of a file that is not in docs/", () => {
		expect(onSite("../../../LICENSE")).toEqual({ address: "../../files/LICENSE.txt", copy: "LICENSE" });
	});

	it("leads nowhere if it is a folder of sources", () => {
		expect(onSite("../../../wasm-core/grammars")).toBeUndefined();
	});
});

describe("the check of links", () => {
	const folder = mkdtempSync(join(tmpdir(), "panicle-docs-"));
	afterAll(() => rmSync(folder, { recursive: true }));
	const write = (path: string, html: string) => {
		mkdirSync(dirname(join(folder, path)), { recursive: true });
		writeFileSync(join(folder, path), html);
	};

	it("reports pages, headings, pictures and files of the app that are missing, but nothing in code", () => {
		write("a.html", '<h2 id="one">One</h2><a href="in/b.html#two">b</a><a href="#one">1</a><a href="../">app</a>');
		write("in/b.html", '<h2 id="two">Two</h2><a href="../a.html">a</a><pre><a href="none.html"></pre>');
		expect(brokenLinks(folder, (path) => path === "")).toEqual([]);
		write(
			"in/b.html",
			'<img src="x.webp"><a href="../a.html#three">a</a><a href="c.html">c</a><a href="../../d">d</a>',
		);
		expect(brokenLinks(folder, (path) => path === "")).toEqual([
			"a.html: in/b.html#two",
			"in/b.html: x.webp",
			"in/b.html: ../a.html#three",
			"in/b.html: c.html",
			"in/b.html: ../../d",
		]);
	});
});

it("numbers the anchors of equal headings, as GitHub does", () => {
	const anchor = anchorMaker();
	expect(["Light & shade", "`age`, [the](x.md) year", "Limits", "Limits"].map(anchor)).toEqual([
		"light--shade",
		"age-the-year",
		"limits",
		"limits-1",
	]);
});
