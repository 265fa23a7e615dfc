import { AnimationMixer, Box3, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { type Aged, growthGlb } from "../../../web/src/formats/growth_glb";
import { agedOf } from "../../../web/src/generate/files/aged";
import type { Part } from "../../../web/src/plant/part";
import { grownParts } from "./grown_parts";
import { complaints, documentOf, load, meshesOf } from "./reading";
import { ABOUT, PULP, tetrahedron } from "./toy_parts";

/** A fruit as high as its age; nothing yet at age 0. */
const AGED = {
	ages: [0, 50, 100],
	at: async (age: number): Promise<Part[]> =>
		age === 0 ? [] : [{ name: "Fruit", shape: { mesh: tetrahedron([0, 0, 0], age / 100), material: PULP } }],
};

describe("the growth of a plant as a GLB", () => {
	it("is plain glTF of which the validator has nothing to say", async () => {
		const glb = await growthGlb(AGED, ABOUT);
		expect(await complaints(glb)).toEqual([]);
		const { extensionsRequired, nodes } = documentOf(glb);
		expect(extensionsRequired).toBeUndefined();
		expect(nodes.filter(({ name }) => name.startsWith("Age"))).toHaveLength(2);
	});

	it("has unique names of nodes, and one material of a kind for all ages", async () => {
		const fruit = (age: number): Part => {
			const material = { ...PULP, colour: [age / 100, 0.2, 0.1] as [number, number, number] };
			return { name: "Fruit", shape: { mesh: tetrahedron([0, 0, 0], age / 100), material } };
		};
		const glb = await growthGlb({ ages: [20, 50, 100], at: async (age) => [fruit(age)] }, ABOUT);
		expect(await complaints(glb)).toEqual([]);
		const { nodes, materials = [] } = documentOf(glb);
		const names = nodes.map(({ name }) => name);
		expect(new Set(names).size).toBe(names.length);
		expect(materials.map(({ name }) => name)).toEqual([PULP.name]);
		// Each age keeps its colour: that of its place in the one picture.
		const { scene } = await load(glb);
		const places = meshesOf(scene).map(({ geometry }) => geometry.getAttribute("uv").getX(0));
		expect(new Set(places.map((u) => u.toFixed(3))).size).toBe(3);
	});

	it("shows one age at a time, in three.js, and the oldest where nothing is played", async () => {
		const { scene, animations } = await load(await growthGlb(AGED, ABOUT));
		expect(animations.map(({ name, duration }) => [name, duration])).toEqual([["Growth", 12]]);
		const heights = () => {
			scene.updateMatrixWorld(true);
			return meshesOf(scene).map((mesh) => new Box3().setFromObject(mesh).getSize(new Vector3()).y);
		};
		const near = (all: number[]) => all.map((value) => expect.closeTo(value, 3));
		expect(heights()).toEqual(near([0, 2]));
		const mixer = new AnimationMixer(scene);
		mixer.clipAction(animations[0]).play();
		const at = (seconds: number) => {
			mixer.setTime(seconds);
			return heights();
		};
		expect(at(1)).toEqual(near([0, 0]));
		expect(at(6)).toEqual(near([1, 0]));
		expect(at(9.9)).toEqual(near([1, 0]));
		expect(at(10.1)).toEqual(near([0, 2]));
		expect(at(11.9)).toEqual(near([0, 2]));
	});
});

describe.each(["bunch/long-conical", "leaf/oak", "tree/bonsai"])("the growth of %s", (source) => {
	/** Of its ages, the first and the last among them; `npm run test:long -- readers` makes all. */
	const EVERY = 12;

	it("takes 7.5 MB at the most, by the ages that are made here", async () => {
		const { model, specimen, core, about } = await grownParts(source);
		const grow: Parameters<typeof agedOf>[2] = async (younger) => model.read(core.grow(model.encode(younger)), younger);
		const aged = agedOf(model, specimen, grow);
		const ages = aged?.ages.filter((_, i) => i % EVERY === 0) ?? [];
		expect(ages.at(-1)).toBe(aged?.ages.at(-1));
		const bytes = (await growthGlb({ ...(aged as Aged), ages }, about)).length;
		expect((bytes / ages.length) * (aged?.ages.length ?? 0)).toBeLessThan(7.5e6);
	});
});
