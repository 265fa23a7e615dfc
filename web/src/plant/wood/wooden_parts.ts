/** Parts of trees and roots: solid meshes as they are, and attached organs as instances. */
import { branchBases } from "../branches";
import type { Material } from "../material";
import { hashFraction } from "../noise";
import { type Part, TRANSFORM } from "../part";
import { partsOf } from "../parts_of";
import { EMPTY_PLANT, type Plant, type PlantMesh } from "../plant";
import { type Bark, woodColours } from "./wood_colours";
import type { Wooden } from "./wooden";

/** Variation among leaves: one material per tint, each for an equal share of the leaves. */
export type Tints = readonly Material[];

/** Materials of trees and roots. */
export interface WoodMaterials {
	/** The material of all solid meshes. */
	readonly wood: Material;
	readonly bark: Bark;
	/** Materials of attached organs, by the kind of their mesh. */
	readonly tints: Readonly<Record<string, Tints>>;
}

/** The most organs of a kind with names of their own, for picking; files hold more than these in a few meshes. */
const MAX_NAMED = 300;

/** Yields the wood, coloured by the thickness of its segments, then the organs. */
export function* woodenParts(plant: Wooden, { wood, bark, tints }: WoodMaterials): Generator<Part> {
	const { meshes, organs } = plant;
	const withInstances = attachedMeshes(organs);
	// Leave out meshes of organs that have no instance.
	const solid = meshes.filter(({ material }, index) => !withInstances.has(index) && !Object.hasOwn(tints, material));
	for (const mesh of solid) {
		const colours = woodColours(plant, mesh, bark);
		const widths = widthsOf(plant, mesh);
		const coloured = { ...mesh, ...(colours ? { colours } : {}), ...(widths ? { widths } : {}) };
		yield* partsOf({ meshes: [coloured], organs: EMPTY_PLANT.organs }, { [mesh.material]: wood });
	}
	yield* attachedParts(plant, tints);
}

/** Returns the diameter of the stem at each vertex, metres; undefined if the plant does not list their segments. */
function widthsOf({ segments, vertexSegments }: Wooden, mesh: PlantMesh): Float32Array | undefined {
	if (!vertexSegments || vertexSegments.length !== mesh.positions.length / 3) return undefined;
	const widths = new Float32Array(vertexSegments.length);
	for (let i = 0; i < widths.length; i++) widths[i] = 2 * segments.radii[2 * vertexSegments[i] + 1];
	return widths;
}

/** Yields the attached organs of a plant, without its wood. */
export function* attachedParts({ meshes, organs, segments }: Plant, tints: WoodMaterials["tints"]): Generator<Part> {
	const attached = attachedMeshes(organs);
	let branches: Int32Array | undefined;
	for (const [index, mesh] of meshes.entries()) {
		if (!attached.has(index)) continue;
		const own = tints[mesh.material] ?? [];
		if (own.length > 1) branches ??= branchBases(segments);
		yield* instancesOf(organs, index, mesh, own, branches);
	}
}

/** Returns the indices of meshes with instances. */
function attachedMeshes({ count, mesh }: Plant["organs"]): Set<number> {
	const attached = new Set<number>();
	let last = -1;
	for (let organ = 0; organ < count; organ++) {
		if (mesh[organ] === last) continue;
		last = mesh[organ];
		attached.add(last);
	}
	return attached;
}

/** Yields a part for each tint of the organs that share a mesh, with an instance for each organ. */
function* instancesOf(
	organs: Plant["organs"],
	index: number,
	mesh: PlantMesh,
	tints: Tints,
	branches: Int32Array | undefined,
): Generator<Part> {
	const members = sorted(organs, index, Math.max(1, tints.length), branches);
	for (const [tint, { count, numbers }] of members.entries()) {
		if (count === 0) continue;
		const own = numbers.subarray(0, count);
		const material = tints[tint] ?? { name: mesh.name, colour: [0.3, 0.4, 0.2], roughness: 0.7 };
		const kind = organs.tags[organs.tag[own[0]]] ?? mesh.name;
		const title = `${kind.charAt(0).toUpperCase()}${kind.slice(1)}`;
		const sky = organs.sky;
		const each = (i: number) => ({ name: `${title} ${own[i] + 1}`, extras: { segment: organs.segment[own[i]] } });
		yield {
			name: members.length > 1 ? `${title} tint ${tint + 1}` : title,
			shape: {
				mesh,
				material,
				instances: {
					transforms: taken(organs.transforms, own),
					...(organs.count > MAX_NAMED ? {} : { each }),
					...(sky ? { sky: own.length === organs.count ? sky : picked(sky, own) } : {}),
				},
			},
		};
	}
}

/**
 * Returns the organs of one mesh by tint. Half of the choice is by the branch, half by a hash of the position, so that
 * each has the same tint while others appear; all tints are equally frequent.
 * @param mesh index of the mesh
 * @param tints number of tints
 * @param branches for each segment its branch (plant/branches.ts)
 * @returns for each tint the indices of its organs; only the first `count` of `numbers` are used
 */
function sorted(
	organs: Plant["organs"],
	mesh: number,
	tints: number,
	branches: Int32Array | undefined,
): { count: number; numbers: Uint32Array }[] {
	const groups = Array.from({ length: tints }, () => ({ count: 0, numbers: new Uint32Array(organs.count) }));
	const { buffer, byteOffset, length } = organs.transforms;
	const bits = new Int32Array(buffer, byteOffset, length);
	for (let organ = 0; organ < organs.count; organ++) {
		if (organs.mesh[organ] !== mesh) continue;
		const at = TRANSFORM * organ;
		const own = hashFraction(bits[at] ^ Math.imul(bits[at + 2], 31), bits[at + 4]);
		const branch = branches?.[organs.segment[organ]] ?? -1;
		const share = branch < 0 ? own : evenMean(own, hashFraction(branch, BRANCH_TINTS));
		const group = groups[Math.min(tints - 1, Math.floor(tints * share))];
		group.numbers[group.count++] = organ;
	}
	return groups;
}

/** Stream of the random numbers of branches. */
const BRANCH_TINTS = 71;

/**
 * Returns the mean of two random numbers, 0 … 1, mapped to be evenly distributed: by the distribution function of the
 * sum of two even numbers.
 */
function evenMean(one: number, other: number): number {
	const mean = 0.5 * (one + other);
	return mean < 0.5 ? 2 * mean * mean : 1 - 2 * (1 - mean) * (1 - mean);
}

/** Returns the sky shares of some organs. */
function picked(sky: Uint8Array, organs: Uint32Array): Uint8Array {
	const into = new Uint8Array(organs.length);
	for (let i = 0; i < organs.length; i++) into[i] = sky[organs[i]];
	return into;
}

/**
 * Returns the transforms of some organs, rounded to a tenth of a millimetre or less: text files become a third smaller.
 */
function taken(transforms: Float32Array, organs: Uint32Array): Float32Array {
	const into = new Float32Array(TRANSFORM * organs.length);
	for (let i = 0; i < organs.length; i++) {
		const from = TRANSFORM * organs[i];
		for (let k = 0; k < TRANSFORM; k++) into[TRANSFORM * i + k] = Math.round(1e4 * transforms[from + k]) / 1e4;
	}
	return into;
}
