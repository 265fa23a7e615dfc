/** Converts an answer's columns to a flower (wasm-core/src/models/flower/model.hpp). */
import type { Answer } from "../../core/core";
import type { Plant, PlantMesh } from "../../plant/plant";
import { readPlant } from "../../plant/read_plant";

/** Volumes in order of creation. */
export interface Volumes {
	/** Names, indexed by `label`. */
	labels: readonly string[];
	/** Module of each of `labels`: 0 is the text itself, then modules in their order. */
	module: Uint32Array;
	label: Uint32Array;
	order: Uint32Array;
	/** Parent volume; 0xffffffff of the first. */
	parent: Uint32Array;
	/** Face of the parent: 0 O, 1 E, from 2 on C1 …; `attached` is 1 for volumes that are not sewn to that face. */
	face: Uint32Array;
	attached: Uint8Array;
	/** Line of the production that grew each volume, and line of its module's call; 0 for none. */
	line: Uint32Array;
	call: Uint32Array;
	/** 9 × volumes: N, T, atx, aty, atz, H, L, W, m. */
	values: Float32Array;
}

/** The generalized map, dart by dart (docs/generalized-maps.md). */
export interface Darts {
	/** α0 … α3, a dart for each dart. */
	alpha: readonly [Uint32Array, Uint32Array, Uint32Array, Uint32Array];
	/** Volume and vertex of each dart. */
	volume: Uint32Array;
	vertex: Uint32Array;
	/** 3 × vertices, metres. */
	positions: Float32Array;
}

/** A flower as one mesh for one viewing distance; its runs are named by their kind of material. */
export interface Level {
	mesh: PlantMesh;
	/** Index of each vertex's paint. */
	paint: Uint8Array;
}

export interface FlowerPlant extends Plant {
	/** Absent from previews. */
	darts?: Darts;
	/** Empty if only levels were requested. */
	volumes: Volumes;
	/** Levels from near to far; empty if not requested. */
	levels: readonly Level[];
	/** Volume of each triangle of each mesh. */
	pickIds: readonly Uint32Array[];
	/** Material number of each mesh. */
	numbers: Uint32Array;
	/** Material name of each mesh; empty for an unnamed material. */
	names: readonly string[];
	/**
	 * 4 × meshes, then 4 × further paints of levels: colours at an organ's base and tip, of its margin and of its
	 * veins; 0xrrggbb in sRGB.
	 */
	colours: Uint32Array;
	/**
	 * 6 per paint: foot, width of the margin, veins to a side, their strength, share of transmitted light, 1 for
	 * feathered veins.
	 */
	paint: Float32Array;
}

const LEVEL = /^level\d$/;
const NONE = new Uint32Array();
const NO_VOLUMES: Volumes = {
	...{ labels: [], module: NONE, label: NONE, order: NONE, parent: NONE, face: NONE, line: NONE, call: NONE },
	attached: new Uint8Array(),
	values: new Float32Array(),
};

/** Reads the answer of the core; meshes of levels of detail are listed apart from the flower's own. */
export function readFlowerPlant(answer: Answer): FlowerPlant {
	const { columns } = answer;
	const { meshes: all, ...plant } = readPlant(answer);
	const meshes = all.filter(({ name }) => !LEVEL.test(name));
	return {
		...plant,
		meshes,
		pickIds: meshes.map(({ name }) => columns.uint32(`mesh.${name}.volume`)),
		levels: all
			.filter(({ name }) => LEVEL.test(name))
			.map((mesh) => ({ mesh, paint: columns.uint8(`mesh.${mesh.name}.paint`) })),
		volumes: columns.has("volumes.label") ? readVolumes(columns) : NO_VOLUMES,
		...(columns.has("alpha0") ? { darts: readDarts(columns) } : {}),
		numbers: columns.has("materials.number") ? columns.uint32("materials.number") : NONE,
		names: columns.has("materials.name") ? columns.text("materials.name").split("\n") : [],
		colours: columns.has("materials.colours") ? columns.uint32("materials.colours") : new Uint32Array(),
		paint: columns.has("materials.paint") ? columns.floats("materials.paint") : new Float32Array(),
	};
}

/** Reads the volumes that the grammar produced: one row each, in the order of the core. */
function readVolumes(columns: Answer["columns"]): Volumes {
	return {
		labels: columns.text("labels").split(" "),
		module: columns.uint32("labels.module"),
		label: columns.uint32("volumes.label"),
		order: columns.uint32("volumes.order"),
		parent: columns.uint32("volumes.parent"),
		face: columns.uint32("volumes.face"),
		attached: columns.uint8("volumes.attached"),
		line: columns.uint32("volumes.line"),
		call: columns.uint32("volumes.call"),
		values: columns.floats("volumes.values"),
	};
}

/** Reads the generalized map: for each dart the four darts that α0 … α3 link it to, its volume and its vertex. */
function readDarts(columns: Answer["columns"]): Darts {
	return {
		alpha: [columns.uint32("alpha0"), columns.uint32("alpha1"), columns.uint32("alpha2"), columns.uint32("alpha3")],
		volume: columns.uint32("darts.volume"),
		vertex: columns.uint32("darts.vertex"),
		positions: columns.floats("vertices.position"),
	};
}
