import { describe, expect, it } from "vitest";
import { aboutPlant } from "../../../../web/src/formats/about_plant";
import { exportGlb } from "../../../../web/src/formats/glb";
import { readFlowerPlant } from "../../../../web/src/models/flower/flower_plant";
import { model } from "../../../../web/src/models/flower/index";
import {
	colourAt,
	colourFromAfar,
	type FlowerPaint,
	paintsOf,
	pictureOf,
} from "../../../../web/src/models/flower/paint";
import { fetchTexts } from "../../../../web/src/models/flower/texts";
import type { Part } from "../../../../web/src/plant/part";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { inRun } from "../../../long_run.mjs";
import { freshCore } from "../../core/wasm";
import { documentOf } from "../../formats/reading";

await fetchTexts();
const core = await freshCore("flower.wasm");

const PLAIN: FlowerPaint = {
	base: [1, 0, 0],
	tip: [0, 0, 1],
	foot: 0.5,
	margin: { colour: [1, 1, 1], width: 0 },
	veins: { colour: [0, 0, 0], count: 0, strength: 0, feathered: false },
	light: 0.5,
};

const LONE = "#define A(4,0,0,0,5,5,5,3)\n#axiom: A\nA -> A[A]_{E}\n";

/** Labels of a petal's volumes: vein, lobes on either side, and the parts on a ligule's sides. */
const LAYER: Readonly<Record<string, string>> = {
	VEIN: "mesophyll",
	M: "mesophyll",
	U: "upper epidermis",
	L: "lower epidermis",
	D: "lower epidermis",
};

function parts(material: string, age = 1): Part[] {
	const preset = fromPreset(model);
	const grammar = `${LONE}#material 3 ${material}`;
	const specimen = { ...preset, grammar, parameters: { ...preset.parameters, age } };
	return [...model.parts(readFlowerPlant(core.grow(model.encode(specimen))))];
}

describe("the paint of organs", () => {
	it.each([false, true])("is as dark from afar as near by, feathered: %s", (feathered) => {
		const white: FlowerPaint["base"] = [1, 1, 1];
		for (const count of [4, 9, 20]) {
			const paint = {
				...PLAIN,
				base: white,
				tip: white,
				veins: { colour: [0, 0, 0] as FlowerPaint["base"], count, strength: 1, feathered },
			};
			const shares = Array.from({ length: 40 }, (_, i) => (i + 0.5) / 40);
			const [mean, first] = [shares, shares.slice(0, 20)].map(
				(along) =>
					along.flatMap((u) => shares.map((v) => 1 - colourFromAfar(paint, u, v)[0])).reduce((a, b) => a + b) /
					(40 * along.length),
			);
			expect(Math.abs(1 - pictureOf(paint).mean[0] - mean)).toBeLessThan(0.012);
			// And fades towards the tip.
			expect(first).toBeGreaterThan(mean);
		}
	});

	it("blends from foot to tip and to a margin, and has the text's number of veins", () => {
		expect(colourAt(PLAIN, 0, 0)).toEqual([1, 0, 0]);
		expect(colourAt(PLAIN, 0.5, 0)).toEqual([0, 0, 1]);
		const edged = { ...PLAIN, margin: { colour: [0, 1, 0] as FlowerPaint["base"], width: 0.2 } };
		expect(colourAt(edged, 1, 1)).toEqual([0, 1, 0]);
		expect(colourAt(edged, 1, 0.79)).toEqual([0, 0, 1]);
		const veined = {
			...PLAIN,
			base: PLAIN.tip,
			veins: { colour: [0, 0, 0] as FlowerPaint["base"], count: 6, strength: 1, feathered: false },
		};
		const blues = Array.from({ length: 1000 }, (_, i) => colourAt(veined, 0.2, i / 1000)[2]);
		const dark = blues.filter((blue, i) => i > 0 && i < 999 && blue < blues[i - 1] && blue <= blues[i + 1]);
		// Half of the middle vein, and the veins within the margin of six, which spread only towards the tip.
		expect(dark.length).toBeGreaterThanOrEqual(6);
		expect(blues[0]).toBe(0);
	});

	it("has veins that branch off a rib if feathered", () => {
		const veins = { colour: [0, 0, 0] as FlowerPaint["base"], count: 6, strength: 1, feathered: true };
		const blue = (u: number, v: number) => colourAt({ ...PLAIN, base: PLAIN.tip, veins }, u, v)[2];
		for (const u of [0.03, 0.3, 0.6]) expect(blue(u, 0)).toBe(0);
		const blues = Array.from({ length: 1000 }, (_, i) => blue(i / 1000, 0.4));
		const dark = blues.flatMap((here, i) =>
			i > 0 && here < 0.95 && here < blues[i - 1] && here <= blues[i + 1] ? [i] : [],
		);
		expect(dark.length).toBe(5);
		// Farther out one has come nearer to the tip.
		expect(blue(dark[2] / 1000, 0.4)).toBeLessThan(0.5);
		expect(blue(dark[2] / 1000, 0.6)).toBeGreaterThan(0.9);
		expect(blue(dark[2] / 1000 + 0.045, 0.6)).toBeLessThan(0.5);
		const [before] = parts('petal "ff0000" veins "000000" 6 1');
		const [read] = parts('petal "ff0000" veins "000000" 6 1 feathered light 0.2');
		expect(read.shape?.material.textures?.colour).not.toBe(before.shape?.material.textures?.colour);
	});

	it("is a picture where veins or a margin want one, a colour for each vertex else", () => {
		const [plain] = parts('petal "ff0000" "0000ff"');
		expect(plain.shape?.material.textures).toBeUndefined();
		expect(plain.shape?.mesh.colours).toBeDefined();
		const [veined] = parts('petal "ff0000" "0000ff" veins "000000" 8 0.5');
		expect(veined.shape?.material.textures?.colour?.width).toBeGreaterThan(100);
		expect(veined.shape?.mesh.colours).toBeUndefined();
		// A drag reuses the same picture, which is not uploaded to the GPU again.
		const [again] = parts('petal "ff0000" "0000ff" veins "000000" 8 0.5');
		expect(again.shape?.material.textures?.colour).toBe(veined.shape?.material.textures?.colour);
		expect(pictureOf({ ...PLAIN, foot: 0.3 }).picture).not.toBe(pictureOf(PLAIN).picture);
	});

	it("has the text's name, in files too: three layers are three primitives", async () => {
		await model.prepare(fromPreset(model));
		expect(parts('petal "ff0000" name "upper epidermis"').map(({ name }) => name)).toEqual(["Upper epidermis"]);
		expect(parts('petal "ff0000"').map(({ name }) => name)).toEqual(["Petal"]);
		for (const [preset, of] of [
			["petal", ""],
			["tulip", "tepal, "],
		]) {
			const specimen = fromPreset(model, preset);
			const plant = readFlowerPlant(core.grow(model.encode(specimen)));
			const about = await aboutPlant(model, plant, specimen, "https://example.org/");
			const { nodes, materials } = documentOf(exportGlb([...model.parts(plant)], about, {}));
			for (const all of [nodes, materials]) {
				const names = (all ?? []).map(({ name }: { name?: string }) => name?.toLowerCase());
				for (const layer of ["upper epidermis", "mesophyll", "lower epidermis"])
					expect(
						names.filter((name) => name === of + layer),
						preset,
					).toHaveLength(1);
			}
		}
	});

	it("has an upper epidermis, a mesophyll and a lower epidermis in every petal, sepal and leaf of every species, and of what is designed", () => {
		const presets = model.presets.list.filter(({ kind }) => /^(?:species|designed)$/.test(kind));
		for (const [i, { name: preset }] of presets.entries()) {
			if (i % inRun(6, 1) !== 0) continue;
			const plant = readFlowerPlant(core.grow(model.encode(fromPreset(model, preset), { sky: false, map: false })));
			const { labels, label, values } = plant.volumes;
			const calledOf = new Map(plant.meshes.map(({ name }, i) => [name, plant.names[i]]));
			for (const [v, of] of label.entries()) {
				const layer = LAYER[/^(?:VEIN|[RL][UML]\d|[UD])$/.exec(labels[of])?.[0].replace(/^[RL](.)\d$/, "$1") ?? ""];
				if (layer === undefined) continue;
				const mesh = `m${values[9 * v + 8]}`;
				expect(calledOf.get(mesh) ?? "unseen", `${preset}: ${labels[of]}`).toMatch(RegExp(`^[a-z ]+, ${layer}$`));
			}
			const made = plant.meshes.map(({ material }, i) => `${material} ${plant.names[i].replace(/.*, /, "")}`);
			// A clock's petals have gone.
			for (const kind of preset === "dandelion-clock" ? ["leaf"] : ["petal", "leaf"])
				for (const layer of Object.values(LAYER)) expect(made, preset).toContain(`${kind} ${layer}`);
			const parts = [...model.parts(plant)].map(({ name }) => name.toLowerCase());
			for (const name of plant.names) expect(parts, preset).toContain(name || parts[0]);
			expect(new Set(parts).size, preset).toBe(parts.length);
		}
	});

	it("transmits light through petals, as much as in the text", () => {
		const through = (material: string) => parts(material)[0].shape?.material.sheet?.through[0];
		expect(through('petal "ff0000" light 0.8')).toBeCloseTo(2 * (through('petal "ff0000" light 0.4') ?? 0));
		expect(through('petal "ff0000"')).toBeGreaterThan(through('leaf "00ff00"') ?? 0);
		expect(through('stem "00ff00"')).toBeUndefined();
		expect(through('petal "ff0000" light 0')).toBeUndefined();
	});

	it("changes with age from bud to wilted", () => {
		const red = (age: number) =>
			parts('petal "ff0000" bud "000000" wilted "800000"', age)[0].shape?.mesh.colours?.[0] ?? 0;
		expect(red(0)).toBe(0);
		expect(red(1)).toBe(1);
		// A bud has coloured before it is open: three quarters of the way when half of its time has gone.
		expect(red(0.5)).toBeCloseTo(0.521, 2);
		expect(red(1.5)).toBeCloseTo(0.527, 2);
		expect(red(2)).toBeCloseTo(0.216, 2);
	});

	it("is in the GLB as it is in view", async () => {
		const specimen = fromPreset(model);
		const made = parts('petal "ff0000" veins "000000" 8 0.5');
		const grown = readFlowerPlant(core.grow(model.encode({ ...specimen, grammar: LONE })));
		const glb = exportGlb(made, await aboutPlant(model, grown, specimen, "https://example.org/"), {});
		const { images, materials = [] } = documentOf(glb);
		expect(images).toHaveLength(1);
		expect(materials[0].pbrMetallicRoughness.baseColorTexture).toBeDefined();
		expect(materials[0].extensions).toHaveProperty("KHR_materials_diffuse_transmission");
	});

	it("is read from the core's columns", () => {
		const [paint] = paintsOf(
			Uint32Array.of(0xff0000, 0x0000ff, 0xffffff, 0x000000),
			Float32Array.of(0.5, 0.25, 7, 0.5, 1, 1),
		);
		expect(paint).toMatchObject({ base: [1, 0, 0], tip: [0, 0, 1], foot: 0.5, margin: { width: 0.25 }, light: 1 });
		expect(paint.veins).toEqual({ colour: [0, 0, 0], count: 7, strength: 0.5, feathered: true });
	});
});

it("parts and materials each have a name of their own, whatever the text calls some", () => {
	const plant = readFlowerPlant(core.grow(model.encode(fromPreset(model))));
	const three = plant.meshes.slice(0, 3).map((mesh) => ({ ...mesh, material: "petal" }));
	expect(three).toHaveLength(3);
	const parts = [...model.parts({ ...plant, meshes: three, names: ["petal 2", "", ""] })];
	expect(parts.map(({ name }) => name)).toEqual(["Petal 2", "Petal", "Petal 3"]);
	expect(parts.map(({ shape }) => shape?.material.name)).toEqual(["Petal 2", "Petal", "Petal 3"]);
});
