/** Plants of a stand as the crowd draws them, and the cells of the ground that hold them. */
import { Box3, type Frustum, type Matrix4, type MeshStandardMaterial, type Vector3 } from "three";
import type { Colour } from "../../../plant/colour";
import type { PackedMesh } from "../../../plant/packed_mesh";
import { STEPS, stepAt } from "../../../render/level_choice";
import type { Slot } from "./batch";

export interface DrawnPlant {
	readonly plant: number;
	/** Centre of the plant. */
	readonly at: Vector3;
	/** Size, metres. */
	readonly size: number;
	readonly slots: readonly Slot[];
	/** Meshes of the finest level, where only a few plants show it at once. */
	readonly fine: readonly FineMesh[];
	/** Slots of the finest level, while this plant shows it. */
	near: readonly Slot[];
	/** Number of triangles of each level. */
	readonly triangles: readonly number[];
	/** Step for the plant's size in the view, without the limit on finest levels. */
	ideal: number;
	/** Shown step and next step (level_choice.ts); −1 for none. */
	shown: number;
	wanted: number;
}

export interface FineMesh {
	readonly mesh: PackedMesh;
	readonly material: MeshStandardMaterial;
	readonly place: Matrix4;
	readonly colour: Colour;
}

/** Cells along each side of the ground. */
const CELLS = 12;

export interface GroundCell {
	readonly box: Box3;
	readonly plants: DrawnPlant[];
	seen: boolean;
}

/** The cells of the ground. */
export class Cells {
	readonly all: readonly GroundCell[] = Array.from({ length: CELLS * CELLS }, () => ({
		box: new Box3(),
		plants: [],
		seen: false,
	}));
	readonly #ground: { readonly width: number; readonly depth: number };

	constructor(ground: { readonly width: number; readonly depth: number }) {
		this.#ground = ground;
	}

	/** Returns the cell in which a point of the ground lies, metres; for points beyond the ground the nearest cell. */
	at(x: number, z: number): GroundCell {
		const cellAlong = (value: number, length: number) =>
			Math.min(CELLS - 1, Math.max(0, Math.floor(CELLS * (value / length + 0.5))));
		return this.all[CELLS * cellAlong(z, this.#ground.depth) + cellAlong(x, this.#ground.width)];
	}

	/**
	 * Chooses the next step of each plant; in invisible cells that of the last level, which casts shadows into view.
	 * Allocates nothing.
	 * @param sizeFactor factor for all sizes; below 1, all plants have coarser levels
	 * @param viewHeight height of the view at a distance of 1
	 * @returns number of visible triangles
	 */
	choose(frustum: Frustum, eye: Vector3, viewHeight: number, sizeFactor: number): number {
		let count = 0;
		for (const cell of this.all) {
			cell.seen = !cell.box.isEmpty() && frustum.intersectsBox(cell.box);
			for (const each of cell.plants) {
				const { at, size, triangles } = each;
				const last = STEPS * (triangles.length - 1);
				const distance = Math.max(at.distanceTo(eye) - 0.5 * size, 0.01);
				each.ideal = cell.seen ? stepAt((sizeFactor * size) / (distance * viewHeight), triangles.length) : last;
				each.wanted = each.fine.length > 0 ? Math.max(STEPS, each.ideal) : each.ideal;
				if (!cell.seen) continue;
				const level = Math.floor(each.wanted / STEPS);
				count += triangles[level] + (each.wanted > STEPS * level ? triangles[level + 1] : 0);
			}
		}
		return count;
	}
}
