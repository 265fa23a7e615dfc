/** Levels of detail of a flower: at each distance one mesh per kind of organ, coloured by vertex. */
import type { Colour } from "../../plant/colour";
import type { Material } from "../../plant/material";
import { cut, type Part } from "../../plant/part";
import type { FlowerPlant } from "./flower_plant";
import { colourFromAfar, type FlowerPaint, paintsOf } from "./paint";
import { materialOf } from "./parts";

/** Returns the parts of each level, in the order of `levels`. */
export function flowerLevels({ levels, colours, paint }: FlowerPlant): Part[][] {
	const paints = paintsOf(colours, paint);
	// All levels share one material per kind, with the mean of the light that its organs transmit.
	const lightsByKind = new Map<string, number[]>();
	for (const { mesh, paint: of } of levels)
		for (const { name, firstVertex, vertexCount } of mesh.runs)
			for (const paintIndex of new Set(of.subarray(firstVertex, firstVertex + vertexCount)))
				lightsByKind.set(name, [...(lightsByKind.get(name) ?? []), paints[paintIndex].light]);
	const materials = new Map<string, Material>();
	for (const [kind, lights] of lightsByKind) materials.set(kind, materialOf(kind, kind, WHITE, rounded(mean(lights))));
	return levels.map(({ mesh, paint: of }) => {
		const colouredMesh = { ...mesh, colours: vertexColours(mesh.uvs, of, paints) };
		return mesh.runs.map((run): Part => {
			const material = materials.get(run.name) as Material;
			return { name: run.name, shape: { mesh: cut(colouredMesh, run), material } };
		});
	});
}

const WHITE: Colour = [1, 1, 1];

/** Mean of at least one number. */
const mean = (values: readonly number[]) => values.reduce((sum, value) => sum + value, 0) / values.length;

/** Rounds transmitted light, so that flowers of one kind share a material. */
const rounded = (light: number) => Math.round(5 * light) / 5;

/**
 * Returns the colours of vertices as they are seen from a distance: 3 × vertices, linear light.
 * @param paintOf index of each vertex's paint
 */
function vertexColours(uvs: Float32Array, paintOf: Uint8Array, paints: readonly FlowerPaint[]): Float32Array {
	const colours = new Float32Array(3 * paintOf.length);
	for (const [v, paint] of paintOf.entries())
		colours.set(colourFromAfar(paints[paint], uvs[2 * v], uvs[2 * v + 1]), 3 * v);
	return colours;
}
