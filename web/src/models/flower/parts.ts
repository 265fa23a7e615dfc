/** Splits a flower into parts: a mesh for each of its materials, painted as its text describes. */
import type { Colour } from "../../plant/colour";
import { type Material, standardMaterial } from "../../plant/material";
import type { Part, PartMesh } from "../../plant/part";
import type { FlowerPlant } from "./flower_plant";
import { colourAt, type FlowerPaint, isFine, paintsOf, pictureOf } from "./paint";

/** Material properties that differ from the standard material of the kind (plant/material.ts). */
const OWN_PROPERTIES: Readonly<Record<string, Partial<Material>>> = {
	stem: { roughness: 0.75 },
	leaf: { roughness: 0.55 },
	petal: { sheen: { colour: [0.12, 0.1, 0.11], roughness: 0.5 } },
};

const KINDS: Readonly<Record<string, string>> = { leaf: "blade" };

/** Tint of transmitted light, which is warmer; half of it is scattered back. */
const TRANSMITTED_TINT: Colour = [1.5, 1.4, 1.2];
const WHITE: Colour = [1, 1, 1];

/** Yields a part for each material, with a picture where its paint is too fine for vertex colours. */
export function* flowerParts(plant: FlowerPlant): Generator<Part> {
	const names = new Set<string>();
	const paints = paintsOf(plant.colours, plant.paint);
	for (const [i, plainMesh] of plant.meshes.entries()) {
		const mesh = { ...plainMesh, pickIds: plant.pickIds[i] };
		const paint = paints[i];
		const title = capital(plant.names[i] || mesh.material);
		// The text may itself use a numbered name.
		let name = title;
		for (let number = 2; names.has(name); number++) name = `${title} ${number}`;
		names.add(name);
		const fine = isFine(paint) ? pictureOf(paint) : undefined;
		const material: Material = {
			...materialOf(mesh.material, name, fine?.mean ?? colourAt(paint, paint.foot / 2, 0), paint.light),
			...(fine ? { textures: { colour: fine.picture } } : {}),
		};
		yield { name, shape: { mesh: fine ? mesh : withVertexColours(mesh, paint), material } };
	}
}

/** Returns a word with a capital first letter. */
const capital = (word: string): string => word.charAt(0).toUpperCase() + word.slice(1);

/**
 * Returns the material of a kind of organ.
 * @param light share of light that is transmitted
 */
export function materialOf(kind: string, name: string, colour: Colour, light: number): Material {
	const { sheet: _, ...usual } = standardMaterial(KINDS[kind] ?? kind);
	return {
		...usual,
		...OWN_PROPERTIES[kind],
		name,
		colour,
		// The mesh is closed, so its back faces are never seen.
		doubleSided: false,
		...(light > 0 ? { sheet: { through: TRANSMITTED_TINT.map((c) => c * light) as Colour, reverse: WHITE } } : {}),
	};
}

/** Colours a mesh by vertex, for paints without fine details. */
function withVertexColours(mesh: PartMesh, paint: FlowerPaint): PartMesh {
	const colours = new Float32Array(mesh.positions.length);
	for (let v = 0; v < colours.length / 3; v++)
		colours.set(colourAt(paint, mesh.uvs[2 * v], mesh.uvs[2 * v + 1]), 3 * v);
	return { ...mesh, colours };
}
