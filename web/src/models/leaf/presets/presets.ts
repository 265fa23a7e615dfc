import { numbersIn, type Preset, type PresetKind } from "../../../specimen/presets";
import { bothSides, KINDS, type LeafKind, type OutlinePoint } from "../outline/points";
import { LEAF_TABLE } from "../table";
import beech from "./beech.json";
import birch from "./birch.json";
import bodhi from "./bodhi.json";
import ginkgo from "./ginkgo.json";
import grapevine from "./grapevine.json";
import ivy from "./ivy.json";
import lilyOfTheValley from "./lily-of-the-valley.json";
import lime from "./lime.json";
import maple from "./maple.json";
import oak from "./oak.json";
import printed from "./printed.json";
import strawberry from "./strawberry.json";
import tulipTree from "./tulip-tree.json";
import willow from "./willow.json";

/** Leaves by how their main veins run. */
export const PRESET_KINDS = [
	{ key: "palmate", title: "Palmate", family: "leaves" },
	{ key: "pinnate", title: "Pinnate", family: "leaves" },
	{ key: "free", title: "Parallel and fan", family: "leaves" },
] as const satisfies readonly PresetKind[];

/** The preset a link without `preset` means. */
export const DEFAULT_PRESET = "grapevine";

/**
 * As the file holds it: choices by name, and the right side of the outline from base to tip, in thousandths: `x y
 * kind`.
 */
interface PresetFile extends Omit<Preset, "parameters"> {
	half: string;
	parameters: Readonly<Partial<Record<string, number | string>>>;
}

const FILES: readonly PresetFile[] = [
	grapevine,
	maple,
	ivy,
	oak,
	lime,
	willow,
	bodhi,
	strawberry,
	birch,
	beech,
	tulipTree,
	ginkgo,
	lilyOfTheValley,
	printed,
];

export const PRESETS: readonly Preset[] = FILES.map(({ half, ...file }) => ({
	...file,
	parameters: numbersIn(LEAF_TABLE, file.parameters),
	details: { outline: outlineOf(half) },
}));

/**
 * Reads the outline of a symmetric leaf from its right side, as preset files have it: `x y kind, x y kind, …`, in
 * thousandths of the leaf's length.
 */
export function outlineOf(half: string): OutlinePoint[] {
	const side = half.split(",").map((written): OutlinePoint => {
		const [x, y, kind = "smooth"] = written.trim().split(/\s+/);
		return { x: Number(x) / 1000, y: Number(y) / 1000, kind: KINDS.find((each) => each === kind) as LeafKind };
	});
	return bothSides(side);
}
