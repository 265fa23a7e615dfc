/** Encodes a specimen as the blocks of a request (wasm-core/src/models/particles/space_request.hpp). */
import type { Block } from "../../../core/container";
import { requestBlocks } from "../../../plant/request";
import type { Table } from "../../../specimen/table";
import type { GrowthOptions } from "../../model";
import type { BoundedSpecimen } from "./bounded";

export interface RequestOptions extends GrowthOptions {
	/** Whether the visibility of the sky is requested; the default is yes with meshes, except for previews. */
	sky?: boolean;
	/** Whether the fingerprint of the meshes is requested; the default is no. */
	meshFingerprint?: boolean;
	/** Whether the light in a tree's crown is requested, cell by cell; the default is no. */
	light?: boolean;
}

/**
 * Encodes a request of a bounded plant, with its boundary, obstacles and targets.
 * @throws CoreError where a parameter is not a number, which specimen/restore.ts prevents
 */
export function encodeBounded(table: Table, specimen: BoundedSpecimen, options: RequestOptions = {}): Block[] {
	const { meshes = true, preview = false, meshFingerprint = false, light = false } = options;
	const { measures = !preview, sky = meshes && !preview } = options;
	const outputs = [
		meshes && "meshes",
		measures && "measures",
		sky && "sky",
		light && "light",
		meshFingerprint && "mesh_fingerprint",
	];
	const { profile, targets, obstacles, rounds, volume, hollow } = specimen;
	const shape = table.option(specimen, "shape");
	const blocks = requestBlocks(specimen, table.core, outputs);
	if (shape === "spline" && profile) blocks.push({ name: "profile", data: Float32Array.from(profile.flat()) });
	if (shape === "mesh" && volume) {
		blocks.push({ name: "volume.points", data: Float32Array.from(volume.points) });
		blocks.push({ name: "volume.triangles", data: Uint32Array.from(volume.triangles) });
	}
	if (hollow) {
		blocks.push({ name: "hollow.points", data: Float32Array.from(hollow.points) });
		blocks.push({ name: "hollow.triangles", data: Uint32Array.from(hollow.triangles) });
	}
	if (targets) blocks.push({ name: "targets", data: Float32Array.from(targets) });
	if (obstacles) blocks.push({ name: "obstacles", data: Float32Array.from(obstacles) });
	if (rounds) blocks.push({ name: "obstacles.round", data: Float32Array.from(rounds) });
	return blocks;
}
