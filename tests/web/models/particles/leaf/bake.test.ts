import { readFile } from "node:fs/promises";
import { beforeAll, describe, expect, it } from "vitest";
import { loadCoreFromBytes } from "../../../../../web/src/core/loader";
import { bakedGlb } from "../../../../../web/src/models/particles/leaf/bake/baked_glb";
import { lightMesh } from "../../../../../web/src/models/particles/leaf/bake/light_mesh";
import { facePictures } from "../../../../../web/src/models/particles/leaf/bake/pictures";
import { veinRaster } from "../../../../../web/src/models/particles/leaf/bake/vein_raster";
import type { Leaf } from "../../../../../web/src/models/particles/leaf/grown";
import { model } from "../../../../../web/src/models/particles/leaf/index";
import { leafFromPreset } from "../../../../../web/src/models/particles/leaf/species";
import { polygonArea } from "../../../../../web/src/models/particles/leaf/words";
import type { PlantMesh } from "../../../../../web/src/plant/plant";
import { complaints, documentOf } from "../../../export/reading";

const specimen = leafFromPreset("grapevine");
let leaf: Leaf;
let upper: PlantMesh;
beforeAll(async () => {
	const core = await loadCoreFromBytes(await readFile("build/core/particles.wasm"));
	leaf = model.read(core.grow(model.encode(specimen)));
	upper = leaf.meshes.find(({ name }) => name === "upper") as PlantMesh;
});

/** Areas of the triangles in the chart. */
function areas({ uvs, indices }: Pick<PlantMesh, "uvs" | "indices">): number[] {
	return Array.from({ length: indices.length / 3 }, (_, triangle) => {
		const [a, b, c] = indices.subarray(3 * triangle, 3 * triangle + 3);
		const [ux, uy] = [uvs[2 * b] - uvs[2 * a], uvs[2 * b + 1] - uvs[2 * a + 1]];
		const [vx, vy] = [uvs[2 * c] - uvs[2 * a], uvs[2 * c + 1] - uvs[2 * a + 1]];
		return (ux * vy - uy * vx) / 2;
	});
}

describe("the light mesh", () => {
	it("has a fifth of the triangles, covers the same, and nothing of it is turned over", () => {
		const light = lightMesh(upper, leaf.faces.upper.edge, 24);
		expect(light.indices.length).toBeLessThan(upper.indices.length / 4);
		const [one, other] = [areas(light), areas(upper)].map((each) => each.reduce((sum, area) => sum + area, 0));
		expect(one / other).toBeCloseTo(1, 3);
		expect(Math.min(...areas(light))).toBeGreaterThanOrEqual(0);
	});
});

describe("the flat leaf in cells", () => {
	it("has the margin's inside, and veins as wide as they are", () => {
		const raster = veinRaster(leaf, specimen.parameters.length, 256);
		const millimetres = (values: Float32Array) =>
			values.reduce((sum, value) => sum + (value > 0 ? 1 : 0), 0) * raster.cell ** 2;
		const area = polygonArea(leaf.margin) * specimen.parameters.length ** 2;
		expect(millimetres(raster.edge) / area).toBeCloseTo(1, 1);
		const { chart, segments } = leaf;
		let veins = 0;
		for (let i = 0; i < segments.count; i++) {
			const length = Math.hypot(chart[4 * i + 2] - chart[4 * i], chart[4 * i + 3] - chart[4 * i + 1]);
			veins += length * specimen.parameters.length * 2000 * segments.radii[2 * i + 1];
		}
		const covered = raster.cover.reduce((sum, share) => sum + share, 0) * raster.cell ** 2;
		expect(covered / veins).toBeGreaterThan(0.6);
		expect(covered / veins).toBeLessThan(1.4);
	});
});

describe("the pictures of a face", () => {
	it("show it tip up, the lower face mirrored, veins raised below and grooved above", () => {
		const raster = veinRaster(leaf, specimen.parameters.length, 128);
		const [above, below] = (["upper", "lower"] as const).map((side) => facePictures(leaf, specimen, raster, side));
		const pixel = ({ width, pixels }: typeof above.colour, x: number, y: number) => [
			...pixels.subarray(3 * (y * width + x), 3 * (y * width + x) + 3),
		];
		// Flat where there is no vein.
		const flat = raster.height.findIndex((_, at) => {
			const [x, y] = [at % 128, Math.floor(at / 128)];
			return (
				x > 0 &&
				y > 0 &&
				x < 127 &&
				y < 127 &&
				[at, at - 1, at + 1, at - 128, at + 128].every((each) => raster.height[each] === 0)
			);
		});
		expect(pixel(above.normal, flat % 128, 127 - Math.floor(flat / 128))).toEqual([128, 128, 255]);
		// Left and right of the steepest flank of a vein: the same flank leans the other way above and below.
		let steepest = { x: 0, y: 0, lean: 0 };
		for (let y = 1; y < 127; y++) {
			for (let x = 1; x < 127; x++) {
				const lean = pixel(below.normal, x, y)[0] - 127.5;
				if (lean > steepest.lean) steepest = { x, y, lean };
			}
		}
		expect(steepest.lean).toBeGreaterThan(10);
		expect(pixel(above.normal, 127 - steepest.x, steepest.y)[0]).toBeGreaterThan(128);
		expect(Math.max(...above.thickness.pixels)).toBe(255);
	});
});

it("a baked leaf is a glTF with three textures a face, to which Khronos' validator has nothing to say", async () => {
	const glb = await bakedGlb(leaf, specimen, "?model=leaf", { pixels: 128 });
	// Whoever shows the normals makes the tangents.
	const found = (await complaints(glb)).filter(({ code }) => code !== "MESH_PRIMITIVE_GENERATED_TANGENT_SPACE");
	expect(found).toEqual([]);
	const { materials = [] } = documentOf(glb) as { materials?: { name: string }[] };
	expect(materials.map(({ name }) => name)).toEqual(["Blade, upper face", "Blade, lower face", "Petiole"]);
	expect((documentOf(glb) as unknown as { textures: unknown[] }).textures).toHaveLength(6);
});
