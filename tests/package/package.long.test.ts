import { execFileSync } from "node:child_process";
import { readdir, readFile } from "node:fs/promises";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { validateBytes } from "gltf-validator";
import { afterAll, beforeAll, describe, expect, it } from "vitest";
import { makePackage, manifest } from "../../wasm-core/tools/package/make.mjs";
import { grow as growByCommand } from "../web/cli/world";
import { filesOfPage, type Project, projectWith } from "./project";

const repository = fileURLToPath(new URL("../../", import.meta.url));
const inRepository = (file: string) => readFile(join(repository, file), "utf8");

let project: Project;
beforeAll(async () => {
	project = await projectWith(await filesOfPage());
});
afterAll(() => project.remove());
const inProject = (file: string) => readFile(join(project.folder, file));

/** A plant as the JSON that the command line prints. */
const RIESLING = ["riesling", "--seed", "7", "--set", "age=80"];

describe("under Node", () => {
	it("grows and writes what the command line does: the page’s first example", async () => {
		const lines = project.run("grow.mjs").trim().split("\n");
		const { json } = await growByCommand(RIESLING);
		expect(lines).toEqual([
			expect.stringMatching(
				new RegExp(
					`^[\\d.]+ cm long, with ${json.counts.berries} berries \\?v=2&preset=riesling&seed=7&age=80 ${json.fingerprint}$`,
				),
			),
			`${json.measures.bunch_length} mm long`,
			`${json.counts.berries} berries in the table`,
			expect.stringMatching(/^1 Oak leaf, \d+ cm²/),
			"125 age: 900 is above the maximum, 125. Using 125.",
			"SpecimenError age 900 is above the maximum, 125.",
			"160 true",
		]);
		for (const [file, ...more] of [
			["bunch.glb"],
			["bunch-low.glb", "--form", "low", "--triangles", "5000"],
			["bunch.obj"],
		]) {
			const { written } = await growByCommand([...RIESLING, ...more, "--out", file.replace("-low", "")]);
			for (const [name, data] of written) {
				const own = await inProject(file === "bunch-low.glb" ? file : name);
				expect(own.equals(Buffer.from(data)), name).toBe(true);
			}
		}
		const { issues } = await validateBytes(new Uint8Array(await inProject("bunch.glb")));
		expect(issues.numErrors + issues.numWarnings).toBe(0);
	});

	it("grows the goldens of links of every version, and other models’ presets", async () => {
		const [paper, natural] = await Promise.all(
			["bunch", "natural"].map(async (name) => JSON.parse(await inRepository(`tests/golden/${name}.json`))),
		);
		const links = {
			"?v=1&preset=short-conical&seed=2": paper["short-conical 2"].fingerprint,
			"?v=1&preset=duku&seed=4294967295": paper["duku 4294967295"].fingerprint,
			"?v=2&preset=merlot&seed=2": natural["merlot 2"].fingerprint,
		};
		const others = ["grammar/shrub", "leaf/oak", "root/carrot", "tree/box", "growth/table-1-hat"];
		for (const each of others) Object.assign(links, { [each]: (await growByCommand([each])).json.fingerprint });
		await project.write({
			"goldens.mjs": `import { grow, models } from "panicle";
				const prints = {};
				for (const asked of ${JSON.stringify(Object.keys(links))}) prints[asked] = (await grow(asked, { meshes: false, measures: false })).fingerprint;
				console.log(JSON.stringify({ prints, models: (await models()).map(({ name }) => name) }));`,
		});
		const output = JSON.parse(project.run("goldens.mjs"));
		expect(output.prints).toEqual(links);
		expect(output.models).toEqual(["bunch", "flower", "grammar", "growth", "leaf", "root", "stand", "tree"]);
	});
});

describe("its types", () => {
	/** Uses every export of the library, by its type alone or by a call. */
	const EVERY = `
import * as library from "panicle";
import type * as types from "panicle";
import { type Grown, type Part, type Plant, type Specimen, formatLink, formats, grow, measures, models, parameters, parseLink, partsOf, presets, to3MF, toFile, toGLB, toJSON, toOBJ, toPLY, toSTL, toUSDZ } from "panicle";
import { type GrownDetail, PanicleSpecimen } from "panicle/element";
import { toObject3D } from "panicle/three";
import type { Group } from "three";
export async function every(): Promise<string> {
	const grown: Grown = await grow({ preset: "riesling", age: 80 }, { targets: { bunch_length: 160 }, signal: AbortSignal.timeout(1000) });
	const plant: Plant = structuredClone(grown).plant;
	const specimen: Specimen = (await parseLink(grown.link)).specimen;
	const parts: Part[] = await partsOf(grown);
	const bytes: Uint8Array[] = [await toGLB(grown, { form: "web" }), await toUSDZ(grown), await to3MF(grown, { thickness: 2 }), await toSTL(grown), await toPLY(grown, { points: 10 })];
	const blob: Blob = await toFile(grown, "csv");
	const group: Group = await toObject3D(grown);
	const obj: string = (await toOBJ(grown)).obj;
	const again: Grown = await grow(specimen);
	const listed = [await models(), await presets("leaf"), await parameters(), await measures(), await formats()].flat();
	const element: PanicleSpecimen = new PanicleSpecimen();
	const detail: GrownDetail = await element.grow();
	const document_ = await toJSON(again);
	// @ts-expect-error there is no such form
	await toGLB(grown, { form: "heavy" });
	try { await grow("x"); } catch (error) {
		if (error instanceof library.CoreError) return \`\${error.line}:\${error.column}\`;
		if (error instanceof library.SpecimenError) return error.problem;
		if (error instanceof library.UnsupportedError || error instanceof library.CoreTrap) return error.message;
	}
	return [bytes.length, blob.size, group.name, obj, listed.length, detail.words, document_.fingerprint, parts.length, plant.segments.count, await formatLink(specimen, "https://plants.example/")].join();
}
export type All = [types.Asked, types.Chance, types.DerivationTrace, types.Colour, types.CoreReason, types.Extras, types.FileOptions, types.FormatInfo, types.GlbForm, types.GlbOptions, types.GrowOptions, types.Instances, types.Material, types.MeasureInfo, types.Mesh, types.MeshRun, types.ModelInfo, types.ModuleAnswer, types.ModuleSpan, types.ObjFiles, types.OrganRecord, types.Organs, types.ParameterInfo, types.ParsedLink, types.PartMesh, types.Picture, types.PlantDocument, types.PlantMesh, types.PresetInfo, types.SegmentRecord, types.Segments, types.Shape, types.TextPlace, types.Textures, types.TraceEntry, types.Values, types.Vector];
`;

	it.each([
		["bundler", "esnext"],
		["node16", "node16"],
	])("are sound to a strict compiler that resolves as %s", async (moduleResolution, module) => {
		await project.borrow("three", "@types/three").catch(() => {});
		const compilerOptions = {
			strict: true,
			noEmit: true,
			target: "es2022",
			lib: ["es2023", "dom"],
			types: [],
			module,
			moduleResolution,
		};
		const tsconfig = JSON.stringify({ compilerOptions, files: ["every.ts", "vineyard.ts"] });
		await project.write({ "every.ts": EVERY, "tsconfig.json": tsconfig });
		const compiler = join(repository, "node_modules/typescript/bin/tsc");
		expect(() => execFileSync(process.execPath, [compiler], { cwd: project.folder, stdio: "pipe" })).not.toThrow();
	});

	it("are asked for by name in the page’s list of exports, all of them", async () => {
		const declared = [
			...(await inProject("node_modules/panicle/panicle.d.ts"))
				.toString()
				.matchAll(/^export (?:declare )?(?:class|function|interface|type) (\w+)/gm),
		];
		const names = declared.map(([, name]) => name);
		expect(names.length).toBeGreaterThan(45);
		expect(names.filter((name) => !new RegExp(`\\b${name}\\b`).test(EVERY))).toEqual([]);
	});
});

describe("what is packed", () => {
	it("has a manifest of its own, with every file that it names", async () => {
		const own = JSON.parse((await inProject("node_modules/panicle/package.json")).toString());
		const { version } = JSON.parse(await inRepository("package.json"));
		expect(own).toMatchObject({ name: "panicle", version, license: "MIT", type: "module" });
		expect(own).not.toHaveProperty("private");
		expect(own).not.toHaveProperty("dependencies");
		expect(own.peerDependenciesMeta).toEqual({ three: { optional: true } });
		expect(own).toEqual(JSON.parse(JSON.stringify(manifest())));
		const named = JSON.stringify(own.exports).matchAll(/"\.\/([\w./-]+\.\w+)"/g);
		for (const [, file] of named)
			expect((await inProject(`node_modules/panicle/${file}`)).length, file).toBeGreaterThan(20);
		for (const file of ["README.md", "LICENSE", "CHANGELOG.md", "THIRD-PARTY.txt", "cores/bunch.wasm"])
			expect((await inProject(`node_modules/panicle/${file}`)).length, file).toBeGreaterThan(200);
	});

	it("has neither the page’s tools nor a script that a worker would miss", async () => {
		const folder = join(project.folder, "node_modules/panicle");
		const scripts = (await readdir(folder, { recursive: true })).filter((file) => file.endsWith(".js"));
		const texts = await Promise.all(
			scripts.map(async (file) => [file, await readFile(join(folder, file), "utf8")] as const),
		);
		expect(texts.filter(([, text]) => /LitElement|from\s*"lit/.test(text)).map(([file]) => file)).toEqual([]);
		const workers = texts.filter(([file]) => file.startsWith("workers"));
		expect(workers.length).toBeGreaterThan(0);
		expect(workers.filter(([, text]) => /\bimport\s*[("{]|\bfrom\s*"/.test(text)).map(([file]) => file)).toEqual([]);
		// Smaller ones would come as data: addresses out of bundlers, which strict policies refuse.
		expect(Math.min(...workers.map(([, text]) => text.length))).toBeGreaterThan(4096);
		const names = (await inProject("node_modules/panicle/THIRD-PARTY.txt")).toString();
		for (const name of ["fflate", "meshoptimizer", "three"]) expect(names).toMatch(new RegExp(`^${name} \\d`, "m"));
	});

	it("is described as its sources’ comments say: docs/api is current, and says of every export what it is", async () => {
		const { pages } = await makePackage();
		for (const [name, text] of Object.entries(pages)) {
			expect(await inRepository(`docs/api/${name}.md`), "run `npm run docs -- api`").toBe(text);
			const sections = text.split("\n### ").slice(1);
			// A heading, then perhaps its signature, then words.
			const bare = sections.filter((each) =>
				/^\w+\n+(?:$|#|\||Throws|Returns)/.test(each.replace(/```ts\n[\s\S]*?\n```\n*/, "")),
			);
			expect(bare).toEqual([]);
			expect(text.split("\n").filter((line) => /^\| `.*\|\s*\|$/.test(line))).toEqual([]);
		}
		const functions = pages.panicle.slice(0, pages.panicle.indexOf("## Classes")).split("\n### ").slice(1);
		const silent = functions.filter((text) => {
			const [, written] = /\(([\s\S]*?)\): Promise/.exec(text) ?? [];
			const asked = [...(written ?? "").replace(/\{[^}]*\}/g, "").matchAll(/(\w+)\??:/g)].map(([, name]) => name);
			return asked.some((name) => !text.includes(`| \`${name}\` |`));
		});
		expect(silent.map((text) => text.split("\n")[0])).toEqual([]);
	});
});
