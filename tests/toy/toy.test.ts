import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { beforeAll, describe, expect, it } from "vitest";
import { run } from "../../web/src/cli/run";
import type { Core } from "../../web/src/core/core";
import { loadCoreFromBytes } from "../../web/src/core/loader";
import { aboutPlant } from "../../web/src/formats/about_plant";
import { exportGlb } from "../../web/src/formats/glb";
import { exportObj } from "../../web/src/formats/obj";
import { addModel, modelNamed, modelNames } from "../../web/src/models/index";
import { fromPreset } from "../../web/src/specimen/from_preset";
import { decodeLink, encodeLink } from "../../web/src/specimen/link";
import { complaint, memoryWorld } from "../web/cli/world";
import { freshCore } from "../web/core/wasm";
import { complaints } from "../web/formats/reading";
import { model, type ToySpecimen } from "./index";

let core: Core;
beforeAll(async () => {
	core = await loadCoreFromBytes(readFileSync("build/core-test/toy.wasm"));
	addModel("toy", async () => model);
});

const upright: ToySpecimen = fromPreset(model);
const grow = (specimen: ToySpecimen) => model.read(core.grow(model.encode(specimen)), specimen);

/** Runs the command where both cores are. */
async function command(...words: string[]) {
	const memory = memoryWorld();
	const loadCore = async (wasm: string) => (wasm === "toy.wasm" ? core : freshCore());
	const status = await run(words, { ...memory.world, loadCore });
	return { status, ...memory };
}

describe("a model of three files", () => {
	it("is named nowhere in the house", () => {
		const grep = [
			"grep",
			"-lwE",
			"toy|Toy",
			"--",
			"web/src",
			"wasm-core/src",
			"wasm-core/parameters",
			"wasm-core/grammars",
		];
		const naming = (() => {
			try {
				return execFileSync("git", grep, { encoding: "utf8" });
			} catch {
				return ""; // git reports this by its exit status.
			}
		})();
		expect(naming).toBe("");
	});

	it("is found by its name, after the default", async () => {
		expect(modelNames()[0]).toBe("bunch");
		expect(modelNames().at(-1)).toBe("toy");
		expect(await modelNamed("toy")).toBe(model);
	});

	it("grows what its text says: three branches at each of three nodes, a fruit on every twig", () => {
		const { segments, organs, counts, notes } = grow(upright);
		expect(segments.count).toBe(1 + 3 + 9 + 27);
		expect(organs.count).toBe(27);
		expect(counts).toEqual({ segments: 40, organs: 27 });
		expect(notes).toEqual([]);
		expect(segments.ends[1]).toBeCloseTo(0);
		expect(segments.ends[4]).toBeCloseTo(0.04);
		const tall = grow({ ...upright, parameters: { ...upright.parameters, height: 100 } });
		expect(tall.segments.ends[4]).toBeCloseTo(0.1);
		expect(grow({ ...upright, grammar: "axiom: F(7)F(7)" }).segments.count).toBe(2);
	});

	it("brings how much of the sky its twigs and fruits see", () => {
		const { organs, meshes } = grow(upright);
		expect(organs.sky).toHaveLength(organs.count);
		expect(Math.min(...(organs.sky ?? []))).toBeLessThan(254);
		expect(meshes[0].sky).toHaveLength(meshes[0].positions.length / 3);
		expect(meshes[1].sky).toBeUndefined();
	});

	it("links, its text in the fragment, and comes back", async () => {
		const specimen = { ...fromPreset(model, "open"), seed: 9, grammar: "axiom: F(3)" };
		const link = await encodeLink(model, specimen);
		expect(link).toMatch(/^\?v=2&model=toy&preset=open&seed=9#g=/);
		const [query, hash] = link.split("#");
		expect(await decodeLink(model, query, hash)).toEqual({ specimen, notes: [] });
	});

	it("is exported as GLB, to which Khronos' validator has nothing to say, and as OBJ", async () => {
		const plant = grow(upright);
		const about = await aboutPlant(model, plant, upright);
		for (const options of [{}, { compact: true }, { instancing: true }]) {
			expect(await complaints(exportGlb(model.parts(plant, upright), about, options))).toEqual([]);
		}
		const { obj, mtl } = exportObj(model.parts(plant, upright), about, "shrub");
		expect(obj.match(/^o /gm)).toHaveLength(28);
		expect(mtl).toContain("newmtl Stem");
	});

	it("is printed and listed by the command line", async () => {
		const { status, printed } = await command("toy/open", "--seed", "3", "--set", "h=50");
		expect(status).toBe(0);
		const json = JSON.parse(printed[0]);
		expect(json).toMatchObject({
			specimen: { model: "toy", preset: "open", seed: 3, parameters: { height: 50 } },
			counts: { segments: 40 },
			measures: {},
			notes: [],
		});
		expect(json.segments[0]).toMatchObject({ parent: -1, kind: "stem", start: [0, 0, 0] });
		expect(json.organs[0].kind).toBe("ball");
		expect(json.organs[0].scale).toBeCloseTo(0.01);
		expect((await command("?model=toy&h=50")).status).toBe(0);
		expect(JSON.parse((await command("--list")).printed[0]).at(-1)).toMatchObject({
			model: "toy",
			title: "Toy shrub",
			presets: ["upright", "open"],
		});
		expect((await command("toy", "--help")).printed[0]).toContain("toy/upright toy/open");
		const { written } = await command("toy", "--out", "shrub.glb");
		expect([...written.keys()]).toEqual(["shrub.glb"]);
		expect(await complaint(["toy", "--out", "x.csv"])).toBe(
			"--out x.csv: The file name must end in .glb, .zip, .usdz, .ply, .3mf, .stl, .obj or .json.",
		);
		expect(await complaint(["toy", "--set", "l=3"])).toBe("--set l: There is no such parameter. See --help.");
	});
});
