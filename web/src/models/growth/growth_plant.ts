/** Converts an answer's columns to a tree of a growth grammar (wasm-core/src/models/growth/model.hpp). */
import type { Answer } from "../../core/core";
import type { AttachedLeaf, Veins } from "../../plant/leaf";
import { fetchBakedLeaf, fetchedLeaf } from "../../plant/leaves";
import { readPlant } from "../../plant/read_plant";
import type { Wooden } from "../../plant/wood/wooden";
import type { GrowthSpecimen } from "./specimen";
import { GROWTH_TABLE } from "./table";
import type { GrowthVolume } from "./volumes/volume";

export interface GrowthPlant extends Wooden {
	/** For each segment its shoot, the shoot's order (0 of a trunk), and the shoot's first step. */
	shoots: { shoot: Uint32Array; order: Uint8Array; born: Uint32Array };
	/** Two words for each shoot of the plant: its address, the lower half first, by which edits name it. */
	addresses: Uint32Array;
	/** Growth volumes of the footprint, as evaluated. */
	volumes: readonly GrowthVolume[];
	/** Veins of every leaf, in its texture coordinates; absent if it has none. */
	veins?: Veins;
}

/** Returns the name of a tree's baked leaf. */
const kindOf = (specimen: GrowthSpecimen): string => GROWTH_TABLE.option(specimen, "leaf_kind") ?? "";

/** Fetches the baked leaf of a tree; needles are not baked, and bare trees have none. */
export const fetchLeafOf = (specimen: GrowthSpecimen): Promise<void> => fetchBakedLeaf(kindOf(specimen));

/** Returns the leaf of a tree; undefined before it is fetched, for needles and for bare trees. */
export const leafOf = (specimen: GrowthSpecimen): AttachedLeaf | undefined => fetchedLeaf(kindOf(specimen));

/** Reads the answer of the core: shoots of segments, and the growth volumes. */
export function readGrowthPlant(answer: Answer, specimen: GrowthSpecimen): GrowthPlant {
	const { columns } = answer;
	const [ids, shapes, places] = [
		columns.uint32("volumes.id"),
		columns.floats("volumes.shape"),
		columns.floats("volumes.at"),
	];
	const child = columns.uint8("volumes.child");
	const middles = columns.floats("volumes.middle");
	const { veins } = leafOf(specimen) ?? {};
	return {
		...readPlant(answer),
		shoots: {
			shoot: columns.uint32("segments.shoot"),
			order: columns.uint8("segments.order"),
			born: columns.uint32("segments.born"),
		},
		addresses: columns.uint32("shoots.address"),
		...(columns.has("segments.dead") ? { deadSegments: columns.uint8("segments.dead") } : {}),
		volumes: [...ids].flatMap((id, i) =>
			child[i] === 1 ? [] : [volumeOf(id, shapes.subarray(5 * i), middles[i], places.subarray(2 * i))],
		),
		...(columns.has("mesh.stems.segment") ? { vertexSegments: columns.uint32("mesh.stems.segment") } : {}),
		...(veins ? { veins } : {}),
	};
}

/** Rounds to hundredths, like the core's handles and texts. */
const hundredth = (value: number): number => Math.round(value * 100) / 100 + 0;

/**
 * Returns a volume from the core's numbers.
 * @param shape base, height, top, gradient and direction of lean
 * @param place x and z of its centre, metres
 */
function volumeOf(id: number, shape: Float32Array, middleWidth: number, place: Float32Array): GrowthVolume {
	const [base, height, top, gradient, towards] = [...shape.subarray(0, 5)].map(hundredth);
	const middle = hundredth(middleWidth);
	return { id, base, height, top, middle, gradient, towards, at: [hundredth(place[0]), hundredth(place[1])] };
}
