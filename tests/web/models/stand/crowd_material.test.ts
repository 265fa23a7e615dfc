import type { MeshStandardMaterial, WebGLRenderer } from "three";
import { expect, it } from "vitest";
import { crowdDepth, crowdMaterial, finishOf } from "../../../../web/src/models/stand/render/crowd_material";
import type { Material } from "../../../../web/src/plant/material";
import { lightUniforms } from "../../../../web/src/render/light_shader";
import { windUniforms } from "../../../../web/src/render/wind_shader";
import { piece, programOf, run } from "./shaders";

const wood: Material = { name: "Wood", colour: [0.4, 0.3, 0.2], roughness: 0.9 };
const made = () => crowdMaterial(wood, false, lightUniforms(), windUniforms());

/** Height of the view at the plant, metres, and in pixels. */
const HIGH = 2;
const PIXELS = 1000;
/** The mesh's unit, metres: the scale of its matrix. */
const UNIT = 0.5;
const widening = piece(programOf(made()).vertexShader, "float metre", "gl_Position");

/**
 * Width on the screen of a stem of a width in pixels.
 * @param normal component of the normal across the stem; `edgeNormal` the same of the edge normal
 */
function drawn(pixels: number, { normal = 1, edgeNormal = 1, seen = PIXELS } = {}): number {
	const metres = (pixels * HIGH) / PIXELS;
	const far = 10;
	const mvPosition = { xyz: 0.5 * metres, z: -far };
	run(widening, {
		...{ mvPosition, normal, viewPixels: seen, modelViewMatrix: 1 },
		projectionMatrix: [undefined, { y: (2 * far) / HIGH }],
		batchingMatrix: [{ xyz: UNIT }],
		edgeNormal: { xyz: edgeNormal, w: Math.sqrt(metres / UNIT) },
	});
	return (2 * mvPosition.xyz * seen) / HIGH;
}

it("draws a stem thinner than a pixel one wide, also where it is half as wide as at its widest", () => {
	for (let across = 0.25; across < 3; across += 0.05) {
		const more = drawn(across) - across;
		expect(0.5 * across + more).toBeGreaterThan(0.87);
		expect(0.5 * across + more).toBeLessThan(Math.max(1.31, 0.5 * across + 1e-9));
	}
});

it("does not widen wide parts, and widens others at most four times", () => {
	for (const across of [2.61, 5, 40]) expect(drawn(across)).toBeCloseTo(across, 9);
	for (const across of [0.001, 0.05, 0.2]) expect(drawn(across)).toBeCloseTo(4 * across, 9);
	for (let across = 0.01; across < 3; across += 0.05) expect(drawn(across)).toBeLessThan(4 * across + 1e-9);
});

it("makes ribbons wider across their margins, as far as tubes out of their middle", () => {
	expect(drawn(0.6, { normal: 0 })).toBeCloseTo(drawn(0.6), 9);
	expect(drawn(0.6, { edgeNormal: 0 })).toBeCloseTo(drawn(0.6), 9);
});

it("widens by the pixels of the drawing buffer: a larger picture needs less", () => {
	expect(drawn(0.6, { seen: 10 * PIXELS })).toBeCloseTo(6, 9);
	const material = made();
	const { viewPixels } = programOf(material).uniforms;
	const renderer = { getCurrentViewport: (into: { w: number }) => Object.assign(into, { w: 720 }) };
	const before = material.onBeforeRender as (renderer: WebGLRenderer) => void;
	before.call(material, renderer as unknown as WebGLRenderer);
	expect(viewPixels.value).toBe(720);
});

it("reads its base from its matrix in the view and in the shadow, and is dithered by its alpha", () => {
	const shaders = [programOf(made()), programOf(crowdDepth() as unknown as MeshStandardMaterial)];
	for (const { vertexShader } of shaders)
		expect(vertexShader).toMatch(/vec4 stem = [\s\S]*batchingMatrix\[3\]\.w = 1\.0;/);
	const [{ vertexShader, fragmentShader }] = shaders;
	expect(vertexShader).toMatch(
		/attribute vec4 edgeNormal;[\s\S]*vec4 windy = batchingMatrix[\s\S]*worldPosition = modelMatrix \* windy;/,
	);
	expect(fragmentShader).toContain("if (grain >= vColor.a) discard;");
});

it("has the same finish for any colour and name, and another for another gloss", () => {
	const finish = finishOf(wood, false);
	expect(finishOf({ ...wood, name: "Bark", colour: [0, 0, 0] }, false)).toBe(finish);
	expect(finishOf({ ...wood, roughness: 0.5 }, false)).not.toBe(finish);
	expect(finishOf(wood, true)).not.toBe(finish);
});
