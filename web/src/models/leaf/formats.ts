/** File formats of leaves in addition to the common ones. */

import type { Format } from "../model";
import type { Leaf } from "./grown";
import { text } from "./messages.generated";
import type { LeafSpecimen } from "./specimen";

export const LEAF_FORMATS: readonly Format<LeafSpecimen, Leaf>[] = [
	{
		key: "svg",
		get title() {
			return text("format_svg");
		},
		get about() {
			return text("format_svg_about");
		},
		suffix: "-veins.svg",
		type: "image/svg+xml",
		make: async (grown, specimen, link) => (await import("./svg")).leafSvg(grown, specimen, link),
	},
	{
		key: "glb-baked",
		get title() {
			return text("format_baked");
		},
		get about() {
			return text("format_baked_about");
		},
		suffix: "-baked.glb",
		type: "model/gltf-binary",
		make: async (grown, specimen, link) => (await import("./bake/baked_glb")).bakedGlb(grown, specimen, link),
	},
];
