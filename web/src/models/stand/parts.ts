/** The parts of a stand: the ground, and the members as instances, at the level of detail for files. */
import { linear } from "../../plant/colour";
import type { Material } from "../../plant/material";
import { unpacked } from "../../plant/packed_mesh";
import { type Part, type PartMesh, TRANSFORM } from "../../plant/part";
import type { MemberMesh } from "../model";
import type { Soil } from "./soil";
import type { StandSpecimen } from "./specimen";
import type { StandPlant } from "./stand_plant";

/** Most plants of one member with individual names. */
const MAX_NAMED = 300;

/** Returns the material of bare soil, in the look's colour. */
function groundMaterial({ look }: StandSpecimen): Material {
	return { name: "Ground", colour: linear(look.soil), roughness: 1 };
}

/** Returns the soil's mesh with vertex colours: the look's colour, times the soil's `light`. */
function tintedSoil({ mesh, light }: Soil, { look }: StandSpecimen): PartMesh {
	const colour = linear(look.soil);
	const colours = new Float32Array(3 * light.length);
	for (let i = 0; i < colours.length; i++) colours[i] = Math.min(1, colour[i % 3] * light[Math.floor(i / 3)]);
	return { ...mesh, colours };
}

const WOOD: Material = { name: "Post", colour: linear("8d7c66"), roughness: 0.95 };
const METAL: Material = { name: "Wire", colour: linear("8f9394"), roughness: 0.45 };

/** Returns the parts that do not grow: the ground, and a trellis's posts and wires. */
export function groundParts({ meshes, soil }: StandPlant, specimen: StandSpecimen): Part[] {
	return meshes.map((mesh) => {
		if (mesh.material === "wood") return { name: "Posts", shape: { mesh, material: WOOD } };
		if (mesh.material === "metal") return { name: "Wires", shape: { mesh, material: METAL } };
		return {
			name: "Ground",
			shape: { mesh: soil ? tintedSoil(soil, specimen) : mesh, material: groundMaterial(specimen) },
		};
	});
}

/** Yields the ground, then each member as instances of all plants that show it, named by the first of them. */
export function* standParts(stand: StandPlant, specimen: StandSpecimen): Generator<Part> {
	yield* groundParts(stand, specimen);
	const plants = plantsOf(stand);
	for (const [index, member] of stand.members.entries()) {
		// A plant without a free organ may have been the only one of its member.
		if (!member || member.levels.length === 0 || !plants[index]) continue;
		const level = member.levels[Math.min(specimen.look.detail, member.levels.length - 1)];
		const { name } = stand.kinds[stand.places.kind[plants[index][0]]];
		yield* partsOf(stand, plants[index], level, `${name} ${plants[index][0] + 1}`);
	}
}

/** Returns for each member the indices of the plants that show it. */
export function plantsOf({ memberOf }: StandPlant): number[][] {
	const plants: number[][] = [];
	for (const [plant, member] of memberOf.entries()) {
		plants[member] ??= [];
		plants[member].push(plant);
	}
	return plants;
}

/** Yields the parts of plants that share their meshes: one for each material, with an instance for each plant. */
function* partsOf(
	stand: StandPlant,
	plants: readonly number[],
	level: readonly MemberMesh[],
	name: string,
): Generator<Part> {
	const transforms = new Float32Array(TRANSFORM * plants.length);
	for (const [i, plant] of plants.entries())
		transforms.set(stand.places.transforms.subarray(TRANSFORM * plant, TRANSFORM * (plant + 1)), TRANSFORM * i);
	const [onlyPlant] = plants.length === 1 ? plants : [];
	for (const { mesh, material } of level) {
		const partName = `${name} ${material.name.toLowerCase()}`;
		const nodeOf = (i: number) => ({ name: `${partName} ${i + 1}`, extras: { plant: plants[i] } });
		const named = onlyPlant === undefined && plants.length <= MAX_NAMED;
		yield {
			name: onlyPlant === undefined ? `${partName} of all` : partName,
			...(onlyPlant === undefined ? {} : { extras: { plant: onlyPlant } }),
			shape: {
				mesh: { ...unpacked(mesh), name: partName },
				material,
				instances: { transforms, ...(named ? { each: nodeOf } : {}) },
			},
		};
	}
}
