import { describe, expect, it } from "vitest";
import { exportGlb, type GlbOptions } from "../../../web/src/formats/glb";
import { png } from "../../../web/src/formats/png";
import { encoded, linear } from "../../../web/src/plant/colour";
import type { Material } from "../../../web/src/plant/material";
import type { Part, Shape } from "../../../web/src/plant/part";
import { tinted } from "../../../web/src/plant/picture";
import { bounced } from "../../../web/src/plant/shade";
import { complaints, documentOf } from "./reading";
import { ABOUT, HAIR, tetrahedron } from "./toy_parts";

const FORMS: GlbOptions[] = [{}, { compact: true }, { instancing: true }, { compact: true, instancing: true }];

describe("textures", () => {
	const picture = { width: 2, height: 2, pixels: Uint8Array.from({ length: 12 }, (_, i) => 20 * i) };
	const parts: Part[] = [
		{
			name: "Sheet",
			shape: {
				mesh: tetrahedron([0, 0, 0], 1),
				material: {
					...HAIR,
					textures: { colour: picture, normal: picture, thickness: picture },
					flesh: { factor: 0.2, thickness: 0.001, colour: [0.5, 0.6, 0.2], distance: 0.001 },
				},
			},
		},
	];

	it.each(FORMS)("lie on the mesh as PNGs in the file, and the validator has no error (%o)", async (form) => {
		const file = exportGlb(parts, ABOUT, { ...form, translucent: true });
		const found = await complaints(file);
		expect(found).toEqual([]);
		const { materials, textures, images, samplers } = documentOf(file);
		expect(materials).toMatchObject([
			{
				pbrMetallicRoughness: { baseColorFactor: [1, 1, 1, 1], baseColorTexture: { index: 0 } },
				normalTexture: { index: 1 },
				extensions: { KHR_materials_volume: { thicknessTexture: { index: 2 } } },
			},
		]);
		expect(textures).toMatchObject([0, 1, 2].map((source) => ({ source, sampler: 0 })));
		expect(images?.map(({ mimeType }) => mimeType)).toEqual(["image/png", "image/png", "image/png"]);
		expect(samplers).toHaveLength(1);
	});

	it("end at their edges, or go on where they are told to repeat", async () => {
		const shape = parts[0].shape as Shape;
		const repeating = { ...shape.material, textures: { ...shape.material.textures, repeats: true } };
		const file = exportGlb([...parts, { name: "Bark", shape: { ...shape, material: repeating } }], ABOUT, {
			translucent: true,
		});
		const { textures, samplers } = documentOf(file);
		expect(samplers).toMatchObject([
			{ wrapS: 33071, wrapT: 33071 },
			{ wrapS: 10497, wrapT: 10497 },
		]);
		expect(textures).toMatchObject([0, 0, 0, 1, 1, 1].map((sampler) => ({ sampler })));
	});

	it("leave vertices without colours of their own with the shade", async () => {
		const shape = parts[0].shape as Shape;
		const mesh = { ...shape.mesh, sky: Uint8Array.of(255, 255, 102, 0) };
		const dressed = exportGlb([{ name: "Sheet", shape: { ...shape, mesh } }], ABOUT);
		// three.js reads no picture without a canvas; this test needs none.
		const { meshes, materials = [], accessors = [], bufferViews = [] } = documentOf(dressed);
		expect(materials[0].pbrMetallicRoughness.baseColorFactor).toEqual([1, 1, 1, 1]);
		const { byteOffset } = bufferViews[accessors[meshes?.[0].primitives[0].attributes.COLOR_0 ?? -1].bufferView];
		const binary = 28 + new DataView(dressed.buffer).getUint32(12, true);
		const bytes = [...dressed.subarray(binary + byteOffset, binary + byteOffset + 16)];
		const shade = HAIR.colour.map((albedo) => Math.round(255 * bounced(0.4, albedo)));
		expect(bytes).toEqual([255, 255, 255, 255, 255, 255, 255, 255, ...shade, 255, 0, 0, 0, 255]);
		const bare = { ...mesh, sky: undefined };
		const plainly = documentOf(exportGlb([{ name: "Sheet", shape: { ...shape, mesh: bare } }], ABOUT));
		expect(plainly.meshes?.[0].primitives[0].attributes).not.toHaveProperty("COLOR_0");
	});

	it("are multiplied by vertices' colours, dimmed as what they show is dimmed", () => {
		const mesh = { ...tetrahedron([0, 0, 0], 1), sky: new Uint8Array(12).fill(255) };
		mesh.sky.fill(0, 0, 3);
		const colours = new Float32Array(mesh.positions.length).fill(0.5);
		const material: Material = {
			name: "Sheet",
			colour: [0.1, 0.1, 0.1],
			roughness: 0.5,
			textures: { colour: picture },
		};
		const sky = mesh.sky.subarray(0, mesh.positions.length / 3);
		const file = exportGlb([{ name: "Sheet", shape: { mesh: { ...mesh, sky, colours }, material } }], ABOUT);
		const [made] = documentOf(file).materials ?? [];
		// F3D knows the picture and colours of vertices, and no factor beside them.
		expect(made.pbrMetallicRoughness.baseColorFactor).toEqual([1, 1, 1, 1]);
		expect(tinted(picture, [0.5, 1, 0]).pixels).toEqual(
			picture.pixels.map((value, at) => {
				const [light] = linear(value.toString(16).padStart(2, "0").repeat(3));
				return at % 3 === 1 ? value : at % 3 === 2 ? 0 : Math.round(255 * encoded([light / 2, 0, 0])[0]);
			}),
		);
		expect(tinted(picture, [1, 1, 1])).toBe(picture);
		const { images = [], bufferViews = [] } = documentOf(file);
		const { byteOffset, byteLength } = bufferViews[images[0].bufferView ?? -1];
		const from = 28 + new DataView(file.buffer).getUint32(12, true) + byteOffset;
		expect(file.slice(from, from + byteLength)).toEqual(png(tinted(picture, [0.5, 0.5, 0.5])));
	});
});

describe("light through sheets", () => {
	const NAME = "KHR_materials_diffuse_transmission";
	const LEAF: Material = { ...HAIR, sheet: { through: [0.4, 0.8, 0.2], reverse: [1, 1, 1] } };
	const reported = (material: Material, options: GlbOptions = {}) => {
		const file = exportGlb([{ name: "Leaf", shape: { mesh: tetrahedron([0, 0, 0], 1), material } }], ABOUT, options);
		const { materials = [], extensionsUsed, extensionsRequired = [] } = documentOf(file);
		const messages = (materials[0].extensions ?? {}) as Record<string, Record<string, number & number[]> | undefined>;
		return { file, reported: messages[NAME], extensionsUsed, extensionsRequired };
	};

	it.each(FORMS)(
		"is to the light that they throw back as in view, and no more than falls on them (%o)",
		async (form) => {
			const { reported: found, extensionsUsed, extensionsRequired } = reported(LEAF, form);
			expect(extensionsUsed).toContain(NAME);
			expect(extensionsRequired).not.toContain(NAME);
			const { diffuseTransmissionFactor: factor, diffuseTransmissionColorFactor: colour } = found as Record<
				string,
				never
			>;
			for (const [k, through] of [0.4, 0.8, 0.2].entries()) {
				const [passing, back] = [factor * colour[k], (1 - factor) * LEAF.colour[k]];
				// lights_fragment of render/standard_material.ts: sheetThrough * sqrt(colour) * colour beside colour.
				expect(passing / back).toBeCloseTo(through * Math.sqrt(LEAF.colour[k]), 4);
				expect(passing + back).toBeLessThanOrEqual(1);
			}
			expect(Math.max(...(colour as number[]))).toBe(1);
		},
	);

	it("has the colours of the sheet's own picture, where there is one", async () => {
		const picture = { width: 2, height: 2, pixels: Uint8Array.from({ length: 12 }, (_, i) => 20 * i) };
		const { file, reported: found } = reported({ ...LEAF, textures: { normal: picture, colour: picture } });
		const { pbrMetallicRoughness } = documentOf(file).materials?.[0] ?? {};
		expect(found?.diffuseTransmissionColorTexture).toEqual(pbrMetallicRoughness?.baseColorTexture);
		const { diffuseTransmissionFactor: factor, diffuseTransmissionColorFactor: colour } = found as Record<
			string,
			never
		>;
		expect((factor * colour[1]) / (1 - factor)).toBeCloseTo(0.8 * Math.sqrt(LEAF.colour[1]), 4);
		// A vertex colour is written as a picture of one pixel, without the transmission of single points.
		const green = tetrahedron([0, 0, 0], 1, [0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0]);
		const plain = documentOf(exportGlb([{ name: "Leaf", shape: { mesh: green, material: LEAF } }], ABOUT));
		expect(JSON.stringify(plain.materials)).not.toContain("diffuseTransmissionColorTexture");
	});

	it("is not told of what lets none through, nor a second time of flesh", () => {
		expect(reported(HAIR).reported).toBeUndefined();
		expect(reported({ ...LEAF, sheet: { through: [0, 0, 0], reverse: [1, 1, 1] } }).reported).toBeUndefined();
		const flesh = { factor: 0.2, thickness: 0.001, colour: [0.5, 0.6, 0.2], distance: 0.001 } as const;
		expect(
			reported({ ...LEAF, flesh: { ...flesh, colour: [...flesh.colour] } }, { translucent: true }).reported,
		).toBeUndefined();
		expect(reported({ ...LEAF, flesh: { ...flesh, colour: [...flesh.colour] } }).reported).toBeDefined();
	});
});
