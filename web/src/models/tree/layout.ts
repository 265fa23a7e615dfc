import { type NumberEntry, nearestWithin } from "../../specimen/table";
import type { BoundaryLayout } from "../particles/boundary/editor/boundary_layout";
import { evenlySpaced, roundly } from "../particles/boundary/editor/boundary_layout";
import type { Form } from "../particles/boundary/editor/outline";
import { text } from "./messages.generated";
import type { TreeSpecimen } from "./specimen";
import { TREE_TABLE } from "./table";

const FORMS: Readonly<Record<string, Form>> = {
	sphere: "ellipsoid",
	ellipsoid: "ellipsoid",
	box: "box",
	cone: "cone",
	spline: "spline",
	mesh: "mesh",
};

const [TRUNK, HEIGHT] = ["trunk", "height"].map((key) => TREE_TABLE.entry(key) as NumberEntry);

/** The boundaries of a tree: crowns side by side, above their trunks. */
export const treeLayout: BoundaryLayout<TreeSpecimen> = {
	form: (specimen) => FORMS[TREE_TABLE.option(specimen, "shape") ?? "ellipsoid"],
	// As in wasm-core/src/models/tree/model.cpp.
	profile: [
		[0.1, 0],
		[0.8, 0.2],
		[1, 0.45],
		[0.7, 0.8],
		[0.08, 1],
	],
	box: (specimen) => {
		const { width, height, trunk } = specimen.parameters;
		return { halfWidth: width / 2, low: trunk, high: trunk + (isBall(specimen) ? width : height) };
	},
	axes: ({ parameters: { crowns, distance } }) => evenlySpaced(crowns, crowns * distance),
	/** Sets the crown's size and position so that it fills a box, in metres. */
	fit: (specimen, { halfWidth, low, high }) => {
		// A crown cannot reach below ground: there its height is reduced, so that its top stays.
		const foot = nearestWithin(TRUNK, Math.min(low, high - HEIGHT.min));
		if (!isBall(specimen)) return { ...roundly(specimen, halfWidth), trunk: foot, height: high - foot };
		const { width, trunk } = specimen.parameters;
		// A sphere takes its size from the side that was moved.
		const size =
			Math.abs(2 * halfWidth - width) > 1e-6 ? 2 * halfWidth : Math.abs(foot - trunk) > 1e-6 ? width : high - foot;
		return { width: size, depth: size, height: size, trunk: foot };
	},
	halfDepth: (specimen) => specimen.parameters[isBall(specimen) ? "width" : "depth"] / 2,
	deepen: (specimen, halfDepth) => {
		const depth = 2 * halfDepth;
		return isBall(specimen) ? { width: depth, depth, height: depth } : { depth };
	},
	targets: ({ parameters: { crowns, distance, stems, width } }) =>
		evenlySpaced(crowns, crowns * distance).flatMap((axis) =>
			evenlySpaced(stems, width).flatMap((x) => [axis + x, 0, 0]),
		),
	move: ({ parameters: { crowns } }, axis) =>
		crowns > 1 ? { distance: (2 * Math.abs(axis)) / (crowns - 1) } : undefined,
	target: "trunk",
	get ends() {
		return { high: text("top"), low: text("lowest_branches") };
	},
	bareAbout: ({ low, high }) => (low + high) / 2,
};

/** Returns whether the crown is a sphere, whose width is its only size. */
function isBall(specimen: TreeSpecimen): boolean {
	return TREE_TABLE.option(specimen, "shape") === "sphere";
}
