import { strFromU8, unzipSync } from "fflate";
import { describe, expect, it } from "vitest";
import { lowGlb } from "../../../web/src/formats/low_glb";
import { paletted, paletteOf } from "../../../web/src/formats/palette";
import { usdz } from "../../../web/src/formats/usdz";
import { encoded, linear } from "../../../web/src/plant/colour";
import type { Picture } from "../../../web/src/plant/material";
import type { Shape } from "../../../web/src/plant/part";
import { documentOf } from "./reading";
import { ABOUT, fruits } from "./toy_parts";

describe("USDZ", () => {
	it("holds its layer first, everything stored and from a multiple of 64 bytes on", async () => {
		const file = await usdz(fruits(), ABOUT);
		const view = new DataView(file.buffer);
		const names: string[] = [];
		for (let at = 0; view.getUint32(at, true) === 0x04034b50; ) {
			const [method, size] = [view.getUint16(at + 8, true), view.getUint32(at + 18, true)];
			const [name, extra] = [view.getUint16(at + 26, true), view.getUint16(at + 28, true)];
			names.push(strFromU8(file.subarray(at + 30, at + 30 + name)));
			const start = at + 30 + name + extra;
			expect([method, start % 64]).toEqual([0, 0]);
			at = start + size;
		}
		expect(names).toEqual(["plant.usda", "textures/colour_0.png"]);
	});

	it("has every triangle where it grew, with colours by way of a picture", async () => {
		const layer = strFromU8(unzipSync(await usdz(fruits(), ABOUT))["plant.usda"]);
		expect(layer.match(/def Mesh /g)).toHaveLength(1);
		const lists = [...layer.matchAll(/point3f\[\] points = \[(.*)\]\n/g)].map(
			([, points]) => points.match(/\(/g)?.length,
		);
		// The tuft is inside the second fruit, where it cannot be seen.
		expect(lists).toEqual([8]);
		const [, extent] = /extent = \[\((.*)\)\]/.exec(layer) ?? [];
		expect(extent).toBe("-0.014, 0.016, 0), (0.014, 0.054, 0.034");
		expect(layer.match(/def Shader "Colour"/g)).toHaveLength(1);
		expect(layer).toContain('string link = "?model=toy&seed=3"');
	});
});

describe("colours as a picture", () => {
	/** The colour of a vertex as a reader interpolates it from the four nearest pixels. */
	function seen({ picture, uvs }: ReturnType<typeof paletteOf>, vertex: number): number[] {
		const { width, pixels } = picture;
		const [x, y] = [uvs[2 * vertex] * width - 0.5, uvs[2 * vertex + 1] * width - 0.5];
		const [i, j] = [Math.min(width - 2, Math.floor(x)), Math.min(width - 2, Math.floor(y))];
		const at = (column: number, row: number, k: number) => pixels[3 * (row * width + column) + k];
		const [s, t] = [x - i, y - j];
		return [0, 1, 2].map(
			(k) =>
				(1 - t) * ((1 - s) * at(i, j, k) + s * at(i + 1, j, k)) +
				t * ((1 - s) * at(i, j + 1, k) + s * at(i + 1, j + 1, k)),
		);
	}

	it("are those of the vertices, where they lie near a plane", () => {
		const [green, red, blue] = ["8ea552", "7a3040", "303a5c"].map(linear);
		const shares = Array.from({ length: 60 }, (_, i) => [(i % 8) / 8, ((i * 5) % 7) / 14]);
		const shown = shares.map(([s, t]) =>
			[0, 1, 2].map((k) => {
				const [a, b, c] = [green, red, blue].map((colour) => encoded(colour)[k]);
				return a + s * (b - a) + t * (c - a);
			}),
		);
		const toLinear = (value: number) => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);
		const palette = paletteOf(Float32Array.from(shown.flat(), toLinear));
		for (const [i, colour] of shown.entries()) {
			for (const [k, value] of seen(palette, i).entries()) expect(Math.abs(value - 255 * colour[k])).toBeLessThan(2);
		}
	});

	it("are one where there is one", () => {
		const palette = paletteOf(Float32Array.of(0.2, 0.3, 0.4, 0.2, 0.3, 0.4));
		const expected = encoded([0.2, 0.3, 0.4]).map((value) => 255 * value);
		for (const [k, value] of seen(palette, 1).entries()) expect(Math.abs(value - expected[k])).toBeLessThan(1);
	});

	it("take the place of those of the vertices, and of no picture that is there", async () => {
		const [{ children: [first, second] = [] }] = paletted(fruits());
		const [{ children: [before] = [] }] = fruits();
		const { mesh, material } = first.shape as Shape;
		expect(mesh.colours).toBeUndefined();
		const picture = material.textures?.colour as Picture;
		const colours = before.shape?.mesh.colours ?? [];
		const wanted = encoded([colours[0], colours[1], colours[2]]).map((value) => 255 * value);
		for (const [k, value] of seen({ picture, uvs: mesh.uvs }, 0).entries())
			expect(Math.abs(value - wanted[k])).toBeLessThan(2);
		// The tuft has instances.
		expect(second.children?.[0]).toEqual(fruits()[0].children?.[1].children?.[0]);
		const pictured = { ...(before.shape as Shape), material: { ...material, textures: { colour: picture } } };
		expect(paletted([{ name: "Leaf", shape: pictured }])[0].shape).toBe(pictured);
	});

	it("are what the low form has, for readers that know no colours of vertices", async () => {
		const { meshes = [], materials = [] } = documentOf(await lowGlb(fruits(), ABOUT, 100));
		for (const { primitives } of meshes) {
			expect(primitives[0].attributes).not.toHaveProperty("COLOR_0");
			if (materials[primitives[0].material].name !== "Pulp") continue;
			expect(primitives[0].attributes).toHaveProperty("TEXCOORD_0");
			expect(materials[primitives[0].material].pbrMetallicRoughness).toMatchObject({
				baseColorFactor: [1, 1, 1, 1],
				baseColorTexture: { index: 0 },
			});
		}
	});
});
