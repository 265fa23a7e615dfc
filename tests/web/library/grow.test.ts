import { strFromU8, unzipSync } from "fflate";
import { describe, expect, it } from "vitest";
import { CoreTrap } from "../../../web/src/core/errors";
import { inRun } from "../../long_run.mjs";
import { grow as growByCommand } from "../cli/world";
import {
	formats,
	grow,
	measures,
	models,
	parameters,
	partsOf,
	presets,
	SMALL,
	toFile,
	toGLB,
	toJSON,
	toOBJ,
} from "./growing";

describe("a grown specimen", () => {
	it("is what the command grows, and says how to have it again", async () => {
		const grown = await grow(SMALL);
		const { json } = await growByCommand(["redcurrant", "--seed", "7", "--set", "count=5"]);
		expect(await toJSON(grown)).toEqual({ ...json, timings: { grow: 0 } });
		expect(grown).toMatchObject({ counts: json.counts, measures: json.measures, fingerprint: json.fingerprint });
		expect(grown.link).toBe("?v=2&preset=redcurrant&seed=7&count=5");
		expect(grown.words).toMatch(/ with 5 berries$/);
		expect((await grow(grown.link)).plant).toEqual(grown.plant);
		expect((await grow(grown.specimen)).fingerprint).toBe(grown.fingerprint);
	});

	it("has notes of a link that could not be used as it was", async () => {
		const { notes, specimen } = await grow("?v=2&preset=redcurrant&count=5&age=900");
		expect(notes[0]).toMatch(/^age: 900 is above/);
		expect(specimen.parameters.age).toBe(125);
	});

	it("may come through a message before its files are made", async () => {
		const grown = await grow(SMALL);
		const copy = structuredClone(grown);
		expect(Buffer.from(await toGLB(copy)).equals(await toGLB(grown))).toBe(true);
		expect((await partsOf(copy)).map(({ name }) => name)).toEqual((await partsOf(grown)).map(({ name }) => name));
	});

	it("without meshes or measures has none, and says so where files want them", async () => {
		const bare = await grow(SMALL, { meshes: false, measures: false });
		expect([bare.meshes, bare.measures]).toEqual([false, {}]);
		const problem = "meshes: The plant was grown without meshes. Grow it again with meshes.";
		for (const make of [toGLB, toOBJ, partsOf]) await expect(make(bare)).rejects.toThrow(problem);
		await expect(toFile(bare, "csv-measures")).rejects.toThrow(
			"format: This plant cannot be exported as csv-measures.",
		);
		expect(await (await toFile(bare, "json")).text()).toContain(bare.fingerprint);
	});

	it("measures what is asked, or says how near it comes", async () => {
		const { measures: got, notes } = await grow("long-conical", { meshes: false, targets: { bunch_length: 160 } });
		expect(got.bunch_length).toBeCloseTo(160, -1);
		expect(notes).toEqual([]);
		const far = await grow(SMALL, { meshes: false, targets: { bunch_weight: 1e6 } });
		expect(far.notes.join()).toMatch(/wanted 1,000,000 g, /);
		await expect(grow(SMALL, { targets: { beauty: 1 } })).rejects.toThrow(
			/^beauty: No such measure can be a target for this plant\. Its possible targets are bunch_length, /,
		);
		await expect(grow(SMALL, { targets: { bunch_length: -1 } })).rejects.toThrow(
			"bunch_length: A target must be a number that is 0 or greater, not -1.",
		);
		await expect(grow("leaf/oak", { targets: { area: 1 } })).rejects.toThrow(/no measures that can be targets\.$/);
	});

	it("tells where a grammar is wrong", async () => {
		const error = await grow({ grammar: "axiom: F(\n" }).catch((each) => each);
		expect(error).toMatchObject({ name: "CoreError", reason: "syntax", line: 1 });
		expect(error).not.toBeInstanceOf(CoreTrap);
	});
});

describe("files", () => {
	it("are of every kind that is listed, those of other models too", async () => {
		const common = (await formats()).map(({ key }) => key);
		for (const requested of [SMALL, { model: "leaf", n: 40 }, { model: "root", n: 40 }]) {
			const grown = await grow(requested);
			for (const { key, type } of await formats(grown.specimen.model)) {
				if (["glb-growth", "glb-lod", "zip-game"].includes(key) || (requested !== SMALL && common.includes(key)))
					continue;
				const file = await toFile(grown, key, { points: 100, triangles: 500, thickness: 4 });
				expect([key, file.type, file.size > 100]).toEqual([key, type, true]);
			}
		}
	});

	it("have the forms and options of the command’s", async () => {
		const grown = await grow(SMALL);
		const call = ["redcurrant", "--seed", "7", "--set", "count=5", "--out", "x.glb"];
		const byCommand = async (...more: string[]) => (await growByCommand([...call, ...more])).written.get("x.glb");
		const forms = [
			[{ translucent: true }, ["--translucent"]],
			[{ form: "low", triangles: 900 }, ["--form", "low", "--triangles", "900"]],
			[{ textures: true }, ["--textures"]],
			[{ form: "growth" }, ["--form", "growth"]],
			[{ form: "wind", triangles: 900 }, ["--form", "wind", "--triangles", "900"]],
		] as const;
		for (const [options, words] of forms.slice(0, inRun(2, forms.length)))
			expect(
				Buffer.from(await toGLB(grown, options)).equals((await byCommand(...words)) as Buffer),
				words.join(" "),
			).toBe(true);
	});

	it("are an OBJ with what it names, which the ZIP has too", async () => {
		const grown = await grow(SMALL);
		const { obj, mtl, pictures } = await toOBJ(grown, "redcurrant");
		expect(obj).toContain("mtllib redcurrant.mtl");
		const entries = unzipSync(new Uint8Array(await (await toFile(grown, "obj")).arrayBuffer()));
		expect(Object.keys(entries).sort()).toEqual(
			["redcurrant.mtl", "redcurrant.obj", ...pictures.map(({ name }) => name)].sort(),
		);
		expect(strFromU8(entries["redcurrant.mtl"])).toBe(mtl);
	});

	it("are refused where there are none", async () => {
		const grown = await grow(SMALL);
		await expect(toFile(grown, "svg")).rejects.toThrow(
			"format: The model bunch has no file format svg. formats() returns all its formats.",
		);
		await expect(toFile(grown, "ply", { points: -1 })).rejects.toThrow(
			"points: options.points must be a whole number from 1 to 2,000,000.",
		);
		const paper = await grow("?v=1&preset=short-conical");
		await expect(toGLB(paper, { form: "growth" })).rejects.toThrow(
			"format: This plant has no age data, so its growth cannot be shown.",
		);
		await expect(toGLB(grown, { form: "lod" })).rejects.toThrow("format: This plant has no levels of detail.");
	});
});

it("the catalogue lists what there is", async () => {
	expect((await models()).map(({ name, preview }) => [name, preview])).toEqual([
		["bunch", false],
		["flower", true],
		["grammar", false],
		["growth", true],
		["leaf", true],
		["root", true],
		["stand", true],
		["tree", true],
	]);
	expect((await presets("leaf")).map(({ name }) => name)).toContain("oak");
	expect((await presets()).length).toBeGreaterThan(25);
	const age = (await parameters()).find(({ key }) => key === "age");
	expect(age).toMatchObject({ kind: "number", min: 0, max: 125 });
	const procedure = (await parameters()).find(({ key }) => key === "procedure");
	expect(procedure).toMatchObject({ kind: "choice", options: ["paper", "natural"], default: "natural" });
	expect((await measures()).find(({ key }) => key === "bunch_length")).toMatchObject({ unit: "mm", kind: "number" });
	await expect(presets("fern")).rejects.toThrow(
		"model: There is no model “fern”. The models are bunch, flower, grammar, growth, leaf, root, stand, tree.",
	);
});
