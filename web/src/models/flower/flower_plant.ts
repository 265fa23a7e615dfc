/** Columns of an answer → a flower (wasm-core/src/models/flower/model.hpp). */
import type { Answer } from "../../core/core";
import type { Plant, PlantMesh } from "../../plant/plant";
import { readPlant } from "../../plant/read_plant";

/** Volumes in the order in which they were made. */
export interface Volumes {
	/** What they are called, by `label`. */
	labels: readonly string[];
	/** The module that each of `labels` is of; 0 the text itself, others in its order. */
	module: Uint32Array;
	label: Uint32Array;
	order: Uint32Array;
	/** That each stands on; 0xffffffff of the first. */
	parent: Uint32Array;
	/** On which of its faces: 0 O, 1 E, from 2 on C1 …; and 1 where it is sewn to nothing there. */
	face: Uint32Array;
	attached: Uint8Array;
	/** The line of the text where each is grown, and where the module is called that it is of; 0 for none. */
	line: Uint32Array;
	call: Uint32Array;
	/** 9 × volumes: N, T, atx, aty, atz, H, L, W, m. */
	values: Float32Array;
}

/** The map dart by dart (docs/generalized-maps.md). */
export interface Darts {
	/** α0 … α3, a dart for each dart. */
	alpha: readonly [Uint32Array, Uint32Array, Uint32Array, Uint32Array];
	/** The volume and the vertex that each is of. */
	volume: Uint32Array;
	vertex: Uint32Array;
	/** 3 × vertices, metres. */
	positions: Float32Array;
}

/** The whole flower as one mesh for one distance; its runs are called by their kind of material. */
export interface Level {
	mesh: PlantMesh;
	/** Of each vertex, which of the flower's paints it has. */
	paint: Uint8Array;
}

export interface FlowerPlant extends Plant {
	/** Absent of what has grown in passing. */
	darts?: Darts;
	/** None of what has grown for its levels alone. */
	volumes: Volumes;
	/** From near to far; none where they were not asked for. */
	levels: readonly Level[];
	/** Of each mesh, of each triangle the volume that it is of. */
	pickIds: readonly Uint32Array[];
	/** Of each mesh, what number the text gives its material. */
	numbers: Uint32Array;
	/** And what it calls it; empty where it does not. */
	names: readonly string[];
	/** 4 × meshes, and behind those 4 for each other paint of levels: where an organ begins and where it ends, of its margin, of its veins; 0xrrggbb as sRGB. */
	colours: Uint32Array;
	/** 6 × as many: foot, width of the margin, veins a side, their strength, light that comes through, 1 where veins are feathered. */
	paint: Float32Array;
}

const LEVEL = /^level\d$/;
const NONE = new Uint32Array();
const NO_VOLUMES: Volumes = {
	...{ labels: [], module: NONE, label: NONE, order: NONE, parent: NONE, face: NONE, line: NONE, call: NONE },
	attached: new Uint8Array(),
	values: new Float32Array(),
};

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

function readDarts(columns: Answer["columns"]): Darts {
	return {
		alpha: [columns.uint32("alpha0"), columns.uint32("alpha1"), columns.uint32("alpha2"), columns.uint32("alpha3")],
		volume: columns.uint32("darts.volume"),
		vertex: columns.uint32("darts.vertex"),
		positions: columns.floats("vertices.position"),
	};
}
