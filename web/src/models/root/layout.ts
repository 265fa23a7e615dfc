import { type NumberEntry, nearestWithin } from "../../specimen/table";
import type { BoundaryLayout } from "../particles/boundary/editor/boundary_layout";
import { evenlySpaced, roundly } from "../particles/boundary/editor/boundary_layout";
import type { Form } from "../particles/boundary/editor/outline";
import { text } from "./messages.generated";
import type { RootSpecimen } from "./specimen";
import { ROOT_TABLE } from "./table";

const FORMS: Readonly<Record<string, Form>> = {
	ball: "ellipsoid",
	bowl: "bowl",
	cone: "coneDown",
	box: "box",
	spline: "spline",
	mesh: "mesh",
};

const TOP = ROOT_TABLE.entry("top") as NumberEntry;

/** The boundary of a root: below ground. */
export const rootLayout: BoundaryLayout<RootSpecimen> = {
	form: (specimen) => FORMS[ROOT_TABLE.option(specimen, "shape") ?? "bowl"],
	// As in wasm-core/src/models/root/model.cpp.
	profile: [
		[0.04, 0],
		[0.16, 0.3],
		[0.34, 0.6],
		[0.7, 0.85],
		[1, 1],
	],
	box: ({ parameters: { width, reach, top } }) => ({ halfWidth: width / 2, low: -top - reach, high: -top }),
	axes: () => [0],
	halfDepth: ({ parameters }) => parameters.depth / 2,
	deepen: (_, halfDepth) => ({ depth: 2 * halfDepth }),
	targets: ({ parameters: { stems, width } }) => evenlySpaced(stems, width).flatMap((x) => [x, 0, 0]),
	fit: (specimen, { halfWidth, low, high }) => {
		const top = nearestWithin(TOP, -high);
		return { ...roundly(specimen, halfWidth), top, reach: -top - low };
	},
	target: "collar",
	get ends() {
		return { high: text("upper_end"), low: text("deepest") };
	},
	bareAbout: ({ high }) => high,
};
