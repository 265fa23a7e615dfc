/** Encodes a specimen as the blocks of a request (wasm-core/src/models/leaf/request.hpp). */
import type { Block } from "../../core/container";
import type { GrowthOptions } from "../model";
import { KINDS } from "./outline/points";
import type { LeafSpecimen } from "./specimen";
import { LEAF_TABLE } from "./table";

export interface LeafOptions extends GrowthOptions {
	/** Whether the visibility of the sky is requested; the default is yes with meshes, except for previews. */
	sky?: boolean;
	/** Whether the fingerprint of the meshes is requested; the default is no. */
	meshFingerprint?: boolean;
	/** Triangles of the blade relative to the core's default. */
	detail?: number;
}

/** Triangles of the blade while particles move, relative to the core's default. */
const WATCHED_DETAIL = 0.25;

/** Encodes a leaf as a request to the core; previews omit outputs that take long. */
export function encodeLeaf(specimen: LeafSpecimen, options: LeafOptions = {}): Block[] {
	const { meshes = true, preview = false, meshFingerprint = false, detail } = options;
	const { measures = !preview, sky = meshes && !preview } = options;
	const { seed, parameters, outline } = specimen;
	// While particles move, all of them are shown; only the blade is coarser.
	const watched = parameters.age < 100;
	const triangles = detail ?? (preview && watched ? WATCHED_DETAIL : undefined);
	const outputs = [
		meshes && "meshes",
		measures && "measures",
		sky && "sky",
		meshFingerprint && "mesh_fingerprint",
		preview && !watched && "draft",
	];
	return [
		{ name: "model", data: "leaf" },
		{ name: "seed", data: Uint32Array.of(seed) },
		{ name: "outputs", data: outputs.filter(Boolean).join(" ") },
		{ name: "parameters", data: Float32Array.from(LEAF_TABLE.core, ({ key }) => parameters[key]) },
		{ name: "outline", data: Float32Array.from(outline.flatMap(({ x, y, kind }) => [x, y, KINDS.indexOf(kind)])) },
		...(triangles === undefined ? [] : [{ name: "detail", data: Float32Array.of(triangles) }]),
	];
}
