import { type Mesh, type MeshPhongMaterial, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { exportObj } from "../../../web/src/formats/obj";
import { png } from "../../../web/src/formats/png";
import { encoded } from "../../../web/src/plant/colour";
import type { Part } from "../../../web/src/plant/part";
import { meshesOf } from "./reading";
import { loadObj, unpicturedMtl } from "./reading_obj";
import { readPng } from "./reading_png";
import { ABOUT, CENTRES, fruits, HAIR, PULP, plain, tetrahedron } from "./toy_parts";

function read(parts: Part[]): Map<string, Mesh> {
	const group = loadObj(exportObj(parts, ABOUT, "toy"));
	return new Map(meshesOf(group).map((mesh) => [mesh.name, mesh]));
}

const corner = (mesh: Mesh | undefined, i: number) =>
	new Vector3().fromBufferAttribute((mesh as Mesh).geometry.attributes.position, i);

describe("the OBJ of any parts", () => {
	it("has one object for each part and each instance, baked where it grew", () => {
		const meshes = read(plain());
		expect([...meshes.keys()]).toEqual(["Trunk", "Branch", "Bract", "Leaf_001", "Leaf_002", "Leaf_003"]);
		expect(corner(meshes.get("Leaf_002"), 1).distanceTo(new Vector3(0.03, 0.18, -0.02))).toBeLessThan(1e-6);
		const normal = new Vector3().fromBufferAttribute((meshes.get("Leaf_002") as Mesh).geometry.attributes.normal, 1);
		expect(normal.distanceTo(new Vector3(1, 0, 0))).toBeLessThan(1e-3);
	});

	it("bakes what hangs on a part where it grew", () => {
		const [x, y, z] = CENTRES[1];
		const meshes = read(fruits());
		expect([...meshes.keys()]).toEqual(["Fruit_1", "Fruit_2", "Tuft"]);
		expect(corner(meshes.get("Tuft"), 0).distanceTo(new Vector3(x - 0.002, y + 0.002, z - 0.002))).toBeLessThan(2e-6);
	});

	it("shares runs of texture coordinates as the parts do", () => {
		const { obj } = exportObj(fruits(), ABOUT, "toy");
		expect(obj.match(/^vt /gm)).toHaveLength(4);
		expect(obj.match(/^v /gm)).toHaveLength(12);
	});

	it("measures textures from the picture's lower edge, as OBJ does", () => {
		const { obj } = exportObj(fruits(), ABOUT, "toy");
		// The parts measure from the upper one: 0 0, 1 0, 1 1, 0 1.
		expect(obj.match(/^vt .*$/gm)).toEqual(["vt 0 1", "vt 1 1", "vt 1 0", "vt 0 0"]);
	});

	it("names where it came from and what it needs", () => {
		const { obj } = exportObj(plain(), ABOUT, "toy");
		const [first, link, library] = obj.split("\n");
		expect(first).toMatch(/^# Panicle [\w.-]+: Toy one, metres, \+Y up$/);
		expect([link, library]).toEqual(["# ?model=toy&seed=3", "mtllib toy.mtl"]);
	});
});

describe("the materials of an OBJ", () => {
	const blocks = (parts: Part[]) =>
		new Map(
			unpicturedMtl(exportObj(parts, ABOUT, "toy"))
				.split("newmtl ")
				.slice(1)
				.map((block) => {
					const [name, ...lines] = block.trim().split("\n");
					return [name, new Map(lines.map((line) => [line.split(" ")[0], line.split(" ").slice(1).map(Number)]))];
				}),
		);

	it("are the mean colour of each variant's parts, the material's own without", () => {
		const found = blocks(fruits());
		expect([...found.keys()]).toEqual(["Pulp", "Pulp_green", "Hair"]);
		const close = (colour: [number, number, number]) => encoded(colour).map((value) => expect.closeTo(value, 2));
		expect(found.get("Pulp")?.get("Kd")).toEqual(close([0.5, 0.2, 0.1]));
		expect(found.get("Pulp_green")?.get("Kd")).toEqual(close([0.2, 0.6, 0.1]));
		expect(found.get("Hair")?.get("Kd")).toEqual(close([0.9, 0.9, 0.8]));
	});

	it("show plain colours as pictures of one pixel, which everyone reads as sRGB, and no colour beside them", () => {
		const { mtl, pictures } = exportObj(fruits(), ABOUT, "toy");
		expect(mtl.match(/^Kd .*$/gm)).toEqual(["Kd 1 1 1", "Kd 1 1 1", "Kd 1 1 1"]);
		const names = ["toy-Pulp-colour.png", "toy-Pulp_green-colour.png", "toy-Hair-colour.png"];
		expect(mtl.match(/^map_Kd .*$/gm)).toEqual(names.map((name) => `map_Kd ${name}`));
		expect(pictures.map(({ name }) => name)).toEqual(names);
	});

	it("have highlights as wide as the roughness says, stronger on what is smooth", () => {
		const matt = { ...PULP, name: "Matt", roughness: Math.SQRT1_2 };
		const found = blocks([...fruits(), { name: "Dull", shape: { mesh: tetrahedron([0, 0, 0], 1), material: matt } }]);
		// Blinn–Phong's exponent: 2 / α² − 2 with α = roughness².
		expect(found.get("Matt")?.get("Ns")).toEqual([6]);
		expect(found.get("Pulp")?.get("Ns")).toEqual([76.1]);
		expect(found.get("Matt")?.get("Ks")?.[0]).toBeLessThan(0.3 * (found.get("Pulp")?.get("Ks")?.[0] ?? 0));
		expect(found.get("Pulp")?.get("Ps")).toEqual([0.12]);
		expect(found.get("Pulp")?.get("Pr")).toEqual([0.4]);
	});

	it("have a name each, though two materials be called the same", () => {
		const other = { ...PULP, colour: [0, 0, 1] as [number, number, number] };
		const meshes = read([
			{ name: "A", shape: { mesh: tetrahedron([0, 0, 0], 1), material: PULP } },
			{ name: "B", shape: { mesh: tetrahedron([3, 0, 0], 1), material: other } },
		]);
		const material = (name: string) => meshes.get(name)?.material as MeshPhongMaterial;
		expect([material("A").name, material("B").name]).toEqual(["Pulp", "Pulp_2"]);
		expect(material("B").color.b).toBe(1);
	});

	it("show colours of vertices by one picture a material, for few readers know them otherwise", () => {
		const blend = (from: number[], to: number[]) => Float32Array.from([...from, ...to, ...from, ...to]);
		const petal = (name: string, x: number, colours: Float32Array): Part => ({
			name,
			shape: { mesh: { ...tetrahedron([x, 0, 0], 1), colours }, material: HAIR },
		});
		const parts = [
			petal("A", 0, blend([1, 0, 0], [0, 0, 1])),
			petal("B", 3, blend([1, 0, 0], [0.2, 0, 0.8])),
			...fruits(),
		];
		const { mtl, pictures, obj } = exportObj(parts, ABOUT, "toy");
		expect(mtl.match(/^newmtl .*$/gm)).toEqual(["newmtl Hair", "newmtl Pulp", "newmtl Pulp_green", "newmtl Hair_2"]);
		expect(mtl).toContain("map_Kd toy-Hair-colour.png");
		const { width, height, pixels } = readPng(pictures[0].bytes);
		const at = (line: string | undefined) => {
			const [u, v] = (line ?? "").split(" ").slice(1).map(Number);
			const pixel = 3 * (Math.floor((1 - v) * height) * width + Math.floor(u * width));
			return [...pixels.subarray(pixel, pixel + 3)];
		};
		const lines = obj.match(/^vt .*$/gm) ?? [];
		const near = (colour: number[]) => colour.map((value) => expect.closeTo(255 * value, -1));
		const shown = (r: number, g: number, b: number) => near([...encoded([r, g, b])]);
		expect(at(lines[0])).toEqual(shown(1, 0, 0));
		expect(at(lines[1])).toEqual(shown(0, 0, 1));
		expect(at(lines[5])).toEqual(shown(0.2, 0, 0.8));
	});

	it("have colours alone where no pictures can lie beside them", () => {
		const { mtl } = exportObj(fruits(), ABOUT, "toy", false);
		expect(mtl).not.toContain("map_Kd");
		expect(mtl.match(/^Kd .*$/gm)?.[0]).not.toBe("Kd 1 1 1");
	});

	it("ask for pictures beside them, each written once, and leave their colour to them", () => {
		const colour = { width: 1, height: 1, pixels: Uint8Array.of(10, 200, 30) };
		const normal = { width: 1, height: 1, pixels: Uint8Array.of(128, 128, 255) };
		const sheet = (name: string, textures: object): Part => ({
			name,
			shape: { mesh: tetrahedron([0, 0, 0], 1), material: { ...PULP, name, textures } },
		});
		const parts = [sheet("Face, up", { colour, normal, thickness: colour }), sheet("Other", { colour })];
		const { mtl, pictures } = exportObj(parts, ABOUT, "my leaf");
		const [first, second] = mtl.split("newmtl ").slice(1);
		expect(first).toContain("Kd 1 1 1\n");
		expect(first).toContain("map_Kd my_leaf-Face_up-colour.png\n");
		expect(first).toContain("norm my_leaf-Face_up-normal.png\n");
		expect(second).toContain("map_Kd my_leaf-Face_up-colour.png\n");
		expect(second).not.toContain("norm");
		expect(pictures).toEqual([
			{ name: "my_leaf-Face_up-colour.png", bytes: png(colour) },
			{ name: "my_leaf-Face_up-normal.png", bytes: png(normal) },
		]);
	});
});
