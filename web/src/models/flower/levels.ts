/** Levels of detail of a flower: at each distance one mesh per kind of organ, coloured by vertex. */
import type { Colour } from "../../plant/colour";
import type { Material } from "../../plant/material";
import { cut, type Part } from "../../plant/part";
import type { FlowerPlant } from "./flower_plant";
import { colourFromAfar, type FlowerPaint, paintsOf } from "./paint";
import { materialOf } from "./parts";

export function flowerLevels({ levels, colours, paint }: FlowerPlant): Part[][] {
	const paints = paintsOf(colours, paint);
	// All levels share one material per kind, with the mean of the light that its organs transmit.
	const light = new Map<string, number[]>();
	for (const { mesh, paint: of } of levels)
		for (const { name, firstVertex, vertexCount } of mesh.runs)
			for (const at of new Set(of.subarray(firstVertex, firstVertex + vertexCount)))
				light.set(name, [...(light.get(name) ?? []), paints[at].light]);
	const materials = new Map<string, Material>();
	for (const [kind, all] of light) materials.set(kind, materialOf(kind, kind, WHITE, rounded(mean(all))));
	return levels.map(({ mesh, paint: of }) => {
		const whole = { ...mesh, colours: coloured(mesh.uvs, of, paints) };
		return mesh.runs.map((run): Part => {
			const material = materials.get(run.name) as Material;
			return { name: run.name, shape: { mesh: cut(whole, run), material } };
		});
	});
}

const WHITE: Colour = [1, 1, 1];

const mean = (values: readonly number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;

/** Rounds transmitted light, so that flowers of one kind share a material. */
const rounded = (light: number) => Math.round(5 * light) / 5;

function coloured(uvs: Float32Array, of: Uint8Array, paints: readonly FlowerPaint[]): Float32Array {
	const colours = new Float32Array(3 * of.length);
	for (const [v, at] of of.entries()) colours.set(colourFromAfar(paints[at], uvs[2 * v], uvs[2 * v + 1]), 3 * v);
	return colours;
}
