import type { BufferGeometry, Mesh, MeshStandardMaterial } from "three";
import { expect, it } from "vitest";
import { GroundRenderer } from "../../../../web/src/models/stand/render/ground_renderer";
import type { Part } from "../../../../web/src/plant/part";
import { lightUniforms } from "../../../../web/src/render/light_shader";
import { piece, programOf, run } from "./shaders";

const groundOf = (red: number, coloured = true): Part => ({
	name: "Ground",
	shape: {
		mesh: {
			positions: new Float32Array(9),
			normals: new Float32Array(9),
			uvs: new Float32Array(6),
			indices: Uint32Array.of(0, 1, 2),
			...(coloured ? { colours: new Float32Array(9).fill(red) } : {}),
		},
		material: { name: "Ground", colour: [red, 0, 0], roughness: 1 },
	},
});
const rim = Float32Array.of(0, 0.5, 1);
const meshOf = ({ object }: GroundRenderer) => object.children[0] as Mesh<BufferGeometry, MeshStandardMaterial>;

it("reuses one material, with one shader program, for all grounds", () => {
	const figure = new GroundRenderer(lightUniforms());
	figure.show(groundOf(0.2), rim, 11);
	const { material, geometry } = meshOf(figure);
	const { version } = material;
	const { patches } = programOf(material).uniforms;
	expect(patches.value).toBe(5);
	const gone: unknown[] = [];
	for (const each of [material, geometry]) each.addEventListener("dispose", ({ target }) => gone.push(target));
	figure.show(groundOf(0.4), rim, 5.5);
	expect(figure.object.children).toHaveLength(1);
	expect(meshOf(figure).material).toBe(material);
	expect(material.version).toBe(version);
	expect(gone).toEqual([geometry]);
	expect(patches.value).toBe(10);
	expect(meshOf(figure).geometry.getAttribute("rim").array).toBe(rim);
	expect(meshOf(figure).geometry.getAttribute("color").getX(0)).toBeCloseTo(0.4, 6);
	figure.show(undefined, rim, 1);
	expect(figure.object.children).toEqual([]);
	expect(gone).not.toContain(material);
	figure.dispose();
	expect(gone).toContain(material);
});

it("has the material's colour without vertex colours, and white with them", () => {
	const figure = new GroundRenderer(lightUniforms());
	const shown = (part: Part) => {
		figure.show(part, rim, 1);
		const { color, vertexColors } = meshOf(figure).material;
		return [color.r, color.g, vertexColors];
	};
	expect(shown(groundOf(0.2, false))).toEqual([0.2, 0, false]);
	expect(shown(groundOf(0.4, false))).toEqual([0.4, 0, false]);
	const { version } = meshOf(figure).material;
	expect(shown(groundOf(0.3))).toEqual([1, 1, true]);
	// One recompilation of the shader program.
	expect(meshOf(figure).material.version).toBe(version + 1);
	figure.dispose();
});

it("fades over its rim, sooner in one place than in another, and is whole before it and gone where it ends", () => {
	const figure = new GroundRenderer(lightUniforms());
	figure.show(groundOf(0.2), rim, 1);
	const { vertexShader, fragmentShader } = programOf(meshOf(figure).material);
	expect(vertexShader).toMatch(/attribute float rim;[\s\S]*rimShare = rim;\s*onGround = patches \* position\.xz;/);
	const fading = piece(fragmentShader, "float patchy", "#include");
	const left = (rimShare: number, noise: number) => {
		const diffuseColor = { a: 1 };
		run(fading, { rimShare, diffuseColor, onGround: 0, vec3: () => 0, noise: () => noise });
		return diffuseColor.a;
	};
	for (const noise of [0, 0.3, 0.45, 0.7, 1]) {
		expect(left(0, noise)).toBe(1);
		expect(left(1, noise)).toBe(0);
		for (let share = 0; share < 1; share += 0.05)
			expect(left(share + 0.05, noise)).toBeLessThanOrEqual(left(share, noise) + 1e-9);
	}
	expect(left(0.5, 0.2)).toBeGreaterThan(0.9);
	expect(left(0.5, 0.8)).toBeLessThan(0.4);
	figure.dispose();
});
