/** Columns of an answer → a tree of a growth grammar (wasm-core/src/models/growth/model.hpp). */
import type { Answer } from "../../core/core";
import type { AttachedLeaf, Veins } from "../../plant/leaf";
import { fetchBakedLeaf, fetchedLeaf } from "../../plant/leaves";
import { readPlant } from "../../plant/read_plant";
import type { Wooden } from "../../plant/wood/wooden";
import type { GrowthSpecimen } from "./specimen";
import { GROWTH_TABLE } from "./table";
import type { GrowthVolume } from "./volumes/volume";

export interface GrowthPlant extends Wooden {
	/** Of each segment the shoot that it is of, that one's order (0 of a trunk), and the step at which it came. */
	shoots: { shoot: Uint32Array; order: Uint8Array; born: Uint32Array };
	/** Those of the footprint, as they came out. */
	volumes: readonly GrowthVolume[];
	/** Of every leaf, over its texture coordinates; absent where it has none. */
	veins?: Veins;
}

const kindOf = (specimen: GrowthSpecimen): string => GROWTH_TABLE.option(specimen, "leaf_kind") ?? "";

/** Fetches the leaf that a tree bears; needles are not baked, and there is none of bare trees. */
export const fetchLeafOf = (specimen: GrowthSpecimen): Promise<void> => fetchBakedLeaf(kindOf(specimen));

/** Undefined before it is there, of needles and of bare trees. */
export const leafOf = (specimen: GrowthSpecimen): AttachedLeaf | undefined => fetchedLeaf(kindOf(specimen));

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
		volumes: [...ids].flatMap((id, i) =>
			child[i] === 1 ? [] : [volumeOf(id, shapes.subarray(5 * i), middles[i], places.subarray(2 * i))],
		),
		...(columns.has("mesh.stems.segment") ? { bearing: columns.uint32("mesh.stems.segment") } : {}),
		...(veins ? { veins } : {}),
	};
}

/** To the hundredth, as the core draws them and texts write them. */
const hundredth = (value: number): number => Math.round(value * 100) / 100 + 0;

function volumeOf(id: number, shape: Float32Array, wide: number, place: Float32Array): GrowthVolume {
	const [base, height, top, gradient, towards] = [...shape.subarray(0, 5)].map(hundredth);
	const middle = hundredth(wide);
	return { id, base, height, top, middle, gradient, towards, at: [hundredth(place[0]), hundredth(place[1])] };
}
