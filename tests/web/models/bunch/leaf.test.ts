import { beforeAll, describe, expect, it } from "vitest";
import { Columns, writeContainer } from "../../../../web/src/core/container";
import type { Core } from "../../../../web/src/core/core";
import { coreText, loadCoreMessages } from "../../../../web/src/core/core_message";
import { model } from "../../../../web/src/models/bunch/index";
import { leafOnCane } from "../../../../web/src/models/bunch/leaf";
import { bunchParts } from "../../../../web/src/models/bunch/parts/bunch_parts";
import { foliageMaterials } from "../../../../web/src/models/bunch/parts/materials";
import { encodeRequest } from "../../../../web/src/models/bunch/request";
import { linear } from "../../../../web/src/plant/colour";
import type { Picture } from "../../../../web/src/plant/material";
import { specimenFromPreset, withParameters } from "../../bunch";
import { freshCore, growBunch } from "../../core/wasm";
import { documentOf } from "../../formats/reading";
import { bunchGlb } from "./parts/files";

const bare = specimenFromPreset("rubus");
const leafy = withParameters(bare, { leaves: 2 });
const requestOf = (specimen: typeof bare, options = {}) =>
	new Columns(writeContainer(encodeRequest(specimen, options)));

let core: Core;
beforeAll(async () => {
	core = await freshCore();
	await loadCoreMessages();
});

// These tests run in order, since fetched leaves stay.
describe("the leaf on the cane", () => {
	it("is not fetched for a bunch without leaves", () => {
		expect(model.prepare(bare)).toBeUndefined();
		expect(leafOnCane()).toBeUndefined();
		expect(requestOf(leafy).has("leaf.points")).toBe(false);
	});

	it("leaves the cane bare, with a note, if it could not be fetched", () => {
		const { foliage, notes } = growBunch(core, leafy);
		expect(foliage?.parts.map(({ kind }) => kind)).toEqual(["cane"]);
		expect(notes.map(coreText)).toEqual([expect.stringMatching(/^The cane has no leaves/)]);
	});

	it("is a sketch until it has come, without petioles: the cane has its own", async () => {
		expect(model.sketch(bare)).toBeUndefined();
		await model.sketch(leafy);
		const sketch = leafOnCane();
		expect(requestOf(leafy).floats("leaf.points")).toEqual(sketch?.points);
		expect(requestOf(leafy).has("leaf.petiole")).toBe(false);
		expect(growBunch(core, leafy).notes).toEqual([]);
		await model.prepare(leafy);
		expect(leafOnCane()?.points.length).toBeGreaterThan(10 * (sketch?.points.length ?? 0));
	});

	it("goes with the request of a bunch that has leaves, and with no other", async () => {
		await model.prepare(leafy);
		const leaf = leafOnCane();
		const request = requestOf(leafy);
		expect(request.floats("leaf.points")).toEqual(leaf?.points);
		expect(request.floats("leaf.between")).toEqual(leaf?.between);
		expect(request.floats("leaf.uvs")).toEqual(leaf?.uvs);
		expect(request.uint32("leaf.triangles")).toEqual(leaf?.indices);
		expect(requestOf(bare).has("leaf.points")).toBe(false);
		expect(requestOf(leafy, { meshes: false }).has("leaf.points")).toBe(false);
	});

	it("is every leaf, each bent its own way, and its veins are the blade's", async () => {
		await model.prepare(leafy);
		const { foliage, notes } = growBunch(core, leafy);
		const leaves = foliage?.parts.filter(({ kind }) => kind === "leaf") ?? [];
		const leaf = leafOnCane();
		expect(notes).toEqual([]);
		expect(leaves).toHaveLength(2);
		for (const { firstVertex, vertexCount, indexCount } of leaves) {
			expect([vertexCount, indexCount]).toEqual([(leaf?.points.length ?? 0) / 2, leaf?.indices.length]);
			expect(foliage?.uvs.slice(2 * firstVertex, 2 * (firstVertex + vertexCount))).toEqual(leaf?.uvs);
		}
		expect(foliage?.veins).toBe(leaf?.veins);
		const cane = growBunch(core, withParameters(bare, { cane: 1 }));
		expect(cane.foliage?.veins).toBeUndefined();
	});
});

describe("a leaf's material", () => {
	const veins = { side: 4, shares: new Uint8Array(16).map((_, at) => (at % 4 === 1 ? 255 : 0)) };
	const pixel = ({ width, pixels }: Picture, x: number, y: number) => [
		...pixels.subarray(3 * (y * width + x), 3 * (y * width + x) + 3),
	];

	it("shows its veins pale between green, and turned once it is autumn", () => {
		const [green, gold] = [0, 1].map((autumn) => foliageMaterials(autumn, veins).leaf.textures?.colour as Picture);
		const [blade, vein] = [pixel(green, 3, 0), pixel(green, 1, 0)];
		expect(blade[1]).toBeGreaterThan(blade[0]);
		expect(blade[0]).toBeGreaterThan(blade[2]);
		for (let k = 0; k < 3; k++) expect(vein[k]).toBeGreaterThan(blade[k] + 30);
		const late = pixel(gold, 3, 0);
		expect(late[0]).toBeGreaterThan(late[1]);
	});

	it("is as bright with its picture as without: vertices darken it", async () => {
		await model.prepare(leafy);
		const grown = growBunch(core, leafy);
		const mean = (each: typeof grown) => {
			const part = [...bunchParts(each, leafy)].find(({ name }) => name === "Leaf 1");
			const { mesh, material } = part?.shape ?? {};
			const picture = material?.textures?.colour;
			const under = picture ? linear(Buffer.from(picture.pixels.subarray(0, 3)).toString("hex")) : [1, 1, 1];
			const colours = mesh?.colours ?? new Float32Array();
			expect(Math.max(...colours)).toBeLessThanOrEqual(1);
			return [0, 1, 2].map(
				(k) => (under[k] * 3 * colours.filter((_, at) => at % 3 === k).reduce((a, b) => a + b, 0)) / colours.length,
			);
		};
		const { veins: _, ...plain } = grown.foliage ?? {};
		const [textured, painted] = [mean(grown), mean({ ...grown, foliage: plain as typeof grown.foliage })];
		for (let k = 0; k < 3; k++) expect(textured[k] / painted[k]).toBeCloseTo(1, 1);
	});

	it("is the same in files as in view: one material with the texture for all leaves", async () => {
		await model.prepare(leafy);
		const document = documentOf(await bunchGlb(growBunch(core, leafy), leafy));
		const leaf = document.materials?.filter(({ name }) => name === "Leaf");
		const [index, ...others] = [...(document.textures ?? []).keys()].filter(
			(at) => document.textures?.[at].name === "Leaf colour",
		);
		expect(others).toEqual([]);
		expect(leaf).toMatchObject([{ pbrMetallicRoughness: { baseColorTexture: { index } }, doubleSided: true }]);
	});
});
