/** File formats of leaves in addition to the common ones. */
import type { Format } from "../model";
import type { Leaf } from "./grown";
import type { LeafSpecimen } from "./specimen";

export const LEAF_FORMATS: readonly Format<LeafSpecimen, Leaf>[] = [
	{
		key: "svg",
		title: "Veins as SVG",
		about: "The flat leaf in millimetres: its margin, and veins as wide as they are",
		suffix: "-veins.svg",
		type: "image/svg+xml",
		make: async (grown, specimen, link) => (await import("./svg")).leafSvg(grown, specimen, link),
	},
	{
		key: "glb-baked",
		title: "GLB, baked",
		about: "A light mesh with textures: colour, normals, thickness",
		suffix: "-baked.glb",
		type: "model/gltf-binary",
		make: async (grown, specimen, link) => (await import("./bake/baked_glb")).bakedGlb(grown, specimen, link),
	},
];
