import fc from "fast-check";
import { Box3, Color, type Mesh, type MeshPhongMaterial, SRGBColorSpace, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { version } from "../../../../../package.json";
import type { BunchPlant } from "../../../../../web/src/models/bunch/bunch_plant";
import { inRun } from "../../../../long_run.mjs";
import { meshesOf } from "../../../formats/reading";
import { loadObj } from "../../../formats/reading_obj";
import { readPng } from "../../../formats/reading_png";
import * as arbitrary from "../arbitrary";
import { makeGrown, paperSpecimen, SKETCH } from "../fixture";
import { bunchObj } from "./files";

const grown = makeGrown(SKETCH);
const specimen = paperSpecimen({ preset: "short-conical", seed: 7 });

/** Loads like a viewer: the materials first, then the meshes that use them. */
const read = (files: ReturnType<typeof bunchObj>): Mesh[] => meshesOf(loadObj(files));

const exported = (from: BunchPlant) => bunchObj(from, specimen, "bunch");
const triangles = (meshes: Mesh[]) =>
	meshes.reduce((sum, { geometry }) => sum + geometry.attributes.position.count / 3, 0);

describe("the OBJ", () => {
	it("is read by three.js with the GLB's names, objects in the same order", () => {
		const names = read(exported(grown)).map(({ name }) => name);
		expect(names).toEqual(["Rachis", "Axis_01", "Axis_02", "Axis_03", "Berry_001", "Berry_002", "Berry_003"]);
	});

	it("holds every triangle of the stems and of each berry, for any growth", () => {
		fc.assert(
			fc.property(arbitrary.sketch, (sketch) => {
				const any = makeGrown(sketch);
				const expected = ((any.stem?.indices.length ?? 0) + any.berries.count * (any.berry?.indices.length ?? 0)) / 3;
				expect(triangles(read(exported(any)))).toBe(expected);
			}),
			{ numRuns: inRun(15, 50) },
		);
	});

	it("puts berries where they grew, to a micrometre, for any growth", () => {
		fc.assert(
			fc.property(arbitrary.sketch, (sketch) => {
				const any = makeGrown(sketch);
				const berries = read(exported(any)).filter(({ name }) => name.startsWith("Berry"));
				berries.forEach(({ geometry }, index) => {
					const [x, y, z, r] = any.berries.spheres.subarray(4 * index);
					const { position, normal } = geometry.attributes;
					const centre = new Vector3(x, y, z);
					for (let i = 0; i < position.count; i++) {
						const arm = new Vector3().fromBufferAttribute(position, i).sub(centre);
						expect(Math.abs(arm.length() - r)).toBeLessThan(1e-6);
						// The fixture's berry is a sphere: its normals point away from the centre.
						const facing = new Vector3().fromBufferAttribute(normal, i).dot(arm) / r;
						expect(facing).toBeGreaterThan(1 - 2e-3 - 1e-6 / r);
					}
				});
			}),
			{ numRuns: inRun(15, 50) },
		);
	});

	it("turns each berry's scar away from its pedicel", () => {
		const berries = read(exported(grown)).filter(({ name }) => name.startsWith("Berry"));
		berries.forEach(({ geometry }, index) => {
			const { position, uv } = geometry.attributes;
			// v is turned over in OBJ: the scar is at 0.
			const scar = Array.from({ length: uv.count }, (_, i) => i).find((i) => uv.getY(i) === 0) ?? -1;
			const [x, y, z, r] = grown.berries.spheres.subarray(4 * index);
			const towards = new Vector3()
				.fromBufferAttribute(position, scar)
				.sub(new Vector3(x, y, z))
				.divideScalar(r);
			const direction = new Vector3(...grown.berries.directions.subarray(3 * index, 3 * index + 3));
			expect(towards.distanceTo(direction)).toBeLessThan(1e-3);
		});
	});

	it("has the growth's bounds", () => {
		const box = new Box3();
		for (const mesh of read(exported(grown)).slice(0, 4)) box.expandByObject(mesh);
		const expected = new Box3().setFromArray(grown.stem?.positions ?? []);
		expect(box.min.distanceTo(expected.min)).toBeLessThan(2e-6);
		expect(box.max.distanceTo(expected.max)).toBeLessThan(2e-6);
	});

	it("gives stems and berries the materials of the MTL", () => {
		const meshes = read(exported(grown));
		expect(meshes.map(({ material }) => (material as MeshPhongMaterial).name)).toEqual([
			...Array(4).fill("Stem"),
			...Array(3).fill("Skin"),
		]);
		const skin = meshes.at(-1)?.material as MeshPhongMaterial;
		expect(skin.color.getHexString()).toBe(specimen.look.skin);
		// A stem's colours change along it: its picture shows them.
		const { pictures } = exported(grown);
		const [{ bytes }] = pictures.filter(({ name }) => name.endsWith("-Stem-colour.png"));
		const { width, height, pixels } = readPng(bytes);
		const { uv } = meshes[0].geometry.attributes;
		const stem = new Color(0, 0, 0);
		for (let i = 0; i < uv.count; i++) {
			const pixel = 3 * (Math.floor((1 - uv.getY(i)) * height) * width + Math.floor(uv.getX(i) * width));
			const [r, g, b] = [...pixels.subarray(pixel, pixel + 3)].map((value) => value / 255);
			stem.add(new Color().setRGB(r, g, b, SRGBColorSpace).multiplyScalar(1 / uv.count));
		}
		const looked = new Color(`#${specimen.look.stem}`);
		expect(Math.hypot(stem.r - looked.r, stem.g - looked.g, stem.b - looked.b)).toBeLessThan(0.08);
	});

	it("names its MTL, its unit and its link", () => {
		const { obj } = bunchObj(grown, specimen, "my bunch\n");
		expect(obj.split("\n").slice(0, 3)).toEqual([
			`# Panicle ${version}: Bunch short-conical, metres, +Y up`,
			"# ?v=2&preset=short-conical&seed=7&procedure=paper",
			"mtllib my bunch .mtl",
		]);
	});

	it("counts right where a part of the stem is empty", () => {
		const stem = { ...(grown.stem as NonNullable<BunchPlant["stem"]>) };
		stem.parts = stem.parts.filter(({ axis }) => axis !== 0);
		const whole = read(exported(grown));
		const meshes = read(exported({ ...grown, stem }));
		const corners = (mesh?: Mesh) => mesh?.geometry.attributes.position.array;
		expect(corners(meshes.find(({ name }) => name === "Axis_02"))).toEqual(
			corners(whole.find(({ name }) => name === "Axis_02")),
		);
		expect(corners(meshes.at(-1))).toEqual(corners(whole.at(-1)));
	});

	it("needs meshes", () => {
		const { stem, berry, ...skeleton } = grown;
		expect(() => exported(skeleton)).toThrow("This bunch has no meshes to export");
	});
});
