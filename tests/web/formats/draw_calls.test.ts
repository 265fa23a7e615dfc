import { describe, expect, it } from "vitest";
import { drawCalls } from "../../../web/src/formats/draw_calls";
import type { Piece } from "../../../web/src/formats/piece";
import { welded } from "../../../web/src/formats/weld";
import type { Colour } from "../../../web/src/plant/colour";
import type { Material, Picture } from "../../../web/src/plant/material";
import { tetrahedron } from "./toy_parts";

const picture = (width: number): Picture => ({ width, height: 1, pixels: new Uint8Array(3 * width) });
const made = (name: string, roughness: number, more: Partial<Material> = {}): Material => ({
	name,
	colour: [0.5, 0.25, 0.1],
	roughness,
	...more,
});
const piece = (material: Material, colours?: number[]): Piece => ({
	material,
	mesh: tetrahedron([0, 0, 0], 1, colours),
});
const names = (pieces: readonly Piece[]) => pieces.map(({ material }) => material.name);
const firstColour = ({ mesh }: Piece, vertex = 0) => [...(mesh.colours ?? []).slice(3 * vertex, 3 * vertex + 3)];
const close = (colour: Colour) => colour.map((value) => expect.closeTo(value, 6));

describe("what is drawn together", () => {
	it("is what shares a material, without texture coordinates where no picture needs them", () => {
		const [bark, leaf] = [made("Bark", 0.9), made("Leaf", 0.6, { textures: { colour: picture(2) } })];
		const calls = drawCalls([piece(bark), piece(leaf), piece(bark)], 5);
		expect(names(calls)).toEqual(["Bark", "Leaf"]);
		expect(calls.map(({ mesh }) => [mesh.positions.length, mesh.uvs.length, mesh.indices.length])).toEqual([
			[24, 0, 24],
			[12, 8, 12],
		]);
		expect(Math.max(...calls[0].mesh.indices)).toBe(7);
		expect(calls[0].mesh.colours).toBeUndefined();
	});

	it("is as few as asked for: those that finish alike, each in its own colour", () => {
		const [dull, matt, wax] = [
			made("Dull", 0.8),
			made("Matt", 0.85, { colour: [0.2, 0.2, 0.2] }),
			made("Wax", 0.3, { clearcoat: { factor: 0.5, roughness: 0.1 } }),
		];
		const calls = drawCalls([piece(dull), piece(matt), piece(matt), piece(wax)], 2);
		expect(names(calls)).toEqual(["Matt", "Wax"]);
		const [both] = calls;
		expect([both.mesh.indices.length / 3, both.material.roughness]).toEqual([12, 0.85]);
		expect(firstColour(both, 0)).toEqual(close([0.2, 0.2, 0.2]));
		expect(firstColour(both, 8)).toEqual(close([0.5, 0.25, 0.1]));
	});

	it("keeps what light comes through apart from what it does not", () => {
		const through: Partial<Material> = { sheet: { through: [1, 1, 1], reverse: [1, 1, 1] } };
		const [petal, leaf, stem] = [made("Petal", 0.5, through), made("Leaf", 0.7, through), made("Stem", 0.6)];
		expect(names(drawCalls([piece(petal), piece(leaf), piece(leaf), piece(stem)], 2))).toEqual(["Leaf", "Stem"]);
	});

	it("takes pictures of one size for tints of one, and others for their means", () => {
		const leaf = (name: string, colour: Colour) => made(name, 0.6, { colour, textures: { colour: picture(4) } });
		const [green, red] = [leaf("Green", [0.2, 0.4, 0.1]), leaf("Red", [0.4, 0.2, 0.1])];
		const [tinted] = drawCalls([piece(green), piece(green), piece(red)], 1);
		expect(tinted.material.textures?.colour).toBe(green.textures?.colour);
		expect(firstColour(tinted, 0)).toEqual(close([1, 1, 1]));
		expect(firstColour(tinted, 8)).toEqual(close([2, 0.5, 1]));
		const bark = made("Bark", 0.6, { colour: [0.3, 0.2, 0.1], textures: { colour: picture(8), repeats: true } });
		const [plain] = drawCalls([piece(green), piece(bark)], 1);
		expect([plain.material.textures, plain.mesh.uvs.length]).toEqual([undefined, 0]);
		expect([firstColour(plain, 0), firstColour(plain, 4)].sort()).toEqual(
			[close([0.2, 0.4, 0.1]), close([0.3, 0.2, 0.1])].sort(),
		);
	});
});

describe("vertices that are equal", () => {
	const positions = Float32Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, -0, 0, 0, 1, 1, 0);
	const indices = Uint32Array.of(0, 1, 2, 3, 1, 4, 0, 3, 1);

	it("become one, and triangles without area go", () => {
		const { indices: left, from, count } = welded({ positions, indices });
		expect([[...left], [...from], count]).toEqual([[0, 1, 2, 0, 1, 3], [0, 1, 2, 4], 4]);
	});

	it("stay apart where something else differs", () => {
		const rows = Int32Array.of(0, 0, 0, 1, 0);
		expect(welded({ positions, indices }, rows).count).toBe(5);
	});
});
