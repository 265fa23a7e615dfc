/** The leaves of a plant that are drawn as instances of a few meshes, apart from its other parts. */
import { rotationMatrix } from "../../plant/orientation";
import { everyPart, type Instances, type Part, type Shape, TRANSFORM, type Vector } from "../../plant/part";
import { LEAST_LEAVES } from "../game/has_crown";

/** A kind of leaves, or of twigs with leaves: one mesh in one material. */
export interface CrownLeafKind {
	readonly shape: Shape & { readonly instances: Instances };
	/** The wood of its twig, an instance at the same places; its card shows both. */
	readonly twig?: Shape | undefined;
}

/** One leaf, or one twig with leaves. */
export interface CrownLeaf {
	readonly kind: number;
	/** Where it begins. */
	readonly place: Vector;
	/** Unit vectors of its mesh's frame: to the right, to the tip, and towards its face. */
	readonly axes: readonly [across: Vector, along: Vector, face: Vector];
	/** Metres per unit of its mesh. */
	readonly scale: number;
	/** The share of the sky that it sees, 0 … 1. */
	readonly sky: number;
}

export interface CrownFoliage {
	readonly kinds: readonly CrownLeafKind[];
	readonly leaves: readonly CrownLeaf[];
	/** Parts that are no such leaves, such as wood and fruits. */
	readonly others: readonly Part[];
}

/** Separates leaves from other parts; undefined for plants with few leaves. */
export function foliageOf(parts: readonly Part[]): CrownFoliage | undefined {
	const kinds: CrownLeafKind[] = [];
	const others: Part[] = [];
	const instanced: Part[] = [];
	for (const part of everyPart(parts)) {
		const { shape } = part;
		if (shape?.instances && shape.material.doubleSided) kinds.push({ shape: { ...shape, instances: shape.instances } });
		else if (shape?.instances && !shape.instances.each) instanced.push(part);
		else if (shape) others.push(part);
	}
	// The wood of twigs has instances at the same places as their leaves.
	const twigAt = new Map(
		instanced.flatMap(({ shape }) => (shape ? placesOf(shape).map((place) => [place, shape] as const) : [])),
	);
	const dressed = kinds.map(({ shape }): CrownLeafKind => ({ shape, twig: twigAt.get(placesOf(shape)[0]) }));
	const twigs = new Set(dressed.map(({ twig }) => twig));
	others.push(...instanced.filter(({ shape }) => !twigs.has(shape)));
	const leaves = kinds.flatMap(({ shape }, kind) => leavesOf(shape.instances, kind));
	return leaves.length < LEAST_LEAVES ? undefined : { kinds: dressed, leaves, others };
}

/** Returns the transform of each instance as text. */
function placesOf({ instances }: Shape): string[] {
	const { transforms = new Float32Array(0) } = instances ?? {};
	return Array.from({ length: transforms.length / TRANSFORM }, (_, i) =>
		transforms.subarray(TRANSFORM * i, TRANSFORM * (i + 1)).join(),
	);
}

/** Returns the leaves of a kind. */
function leavesOf({ transforms, sky }: Instances, kind: number): CrownLeaf[] {
	return Array.from({ length: transforms.length / TRANSFORM }, (_, index): CrownLeaf => {
		const [x, y, z, qx, qy, qz, qw, scale] = transforms.subarray(TRANSFORM * index, TRANSFORM * (index + 1));
		const m = rotationMatrix({ x: qx, y: qy, z: qz, w: qw });
		return {
			kind,
			place: [x, y, z],
			axes: [
				[m[0], m[3], m[6]],
				[m[1], m[4], m[7]],
				[m[2], m[5], m[8]],
			],
			scale,
			sky: (sky?.[index] ?? 255) / 255,
		};
	});
}
