/** A plant of a stand as the crowd draws it, and the cell of the ground that it stands in. */
import { Box3, type Frustum, type Matrix4, type MeshStandardMaterial, type Vector3 } from "three";
import type { Colour } from "../../../plant/colour";
import type { PackedMesh } from "../../../plant/packed_mesh";
import type { Slot } from "./batch";
import { STEPS, stepAt } from "./level_choice";

export interface DrawnPlant {
	readonly plant: number;
	/** The middle of it. */
	readonly at: Vector3;
	/** As large as this, metres. */
	readonly size: number;
	readonly slots: readonly Slot[];
	/** What its finest level is made of, where that is only shown of few at once. */
	readonly fine: readonly FineMesh[];
	/** Its finest level, while it is one of these. */
	near: readonly Slot[];
	/** Of each level. */
	readonly triangles: readonly number[];
	/** What its size asks for, were it shown as finely as it can be. */
	ideal: number;
	/** As level_choice.ts counts: what is shown, and what is to be; −1 of what is not. */
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

export interface Cell {
	readonly box: Box3;
	readonly plants: DrawnPlant[];
	seen: boolean;
}

/** The ground's cells. */
export class Cells {
	readonly all: readonly Cell[] = Array.from({ length: CELLS * CELLS }, () => ({
		box: new Box3(),
		plants: [],
		seen: false,
	}));
	readonly #ground: { readonly width: number; readonly depth: number };

	constructor(ground: { readonly width: number; readonly depth: number }) {
		this.#ground = ground;
	}

	at(x: number, z: number): Cell {
		const along = (value: number, length: number) =>
			Math.min(CELLS - 1, Math.max(0, Math.floor(CELLS * (value / length + 0.5))));
		return this.all[CELLS * along(z, this.#ground.depth) + along(x, this.#ground.width)];
	}

	/**
	 * Settles what each plant wants to be shown as: in cells out of sight by its last level, which throws shadows into sight. Allocates
	 * nothing.
	 * @param modest what all sizes are multiplied by
	 * @param high how high the view is at a distance of 1
	 * @returns how many triangles these are, those out of sight left out
	 */
	choose(frustum: Frustum, eye: Vector3, high: number, modest: number): number {
		let count = 0;
		for (const cell of this.all) {
			cell.seen = !cell.box.isEmpty() && frustum.intersectsBox(cell.box);
			for (const each of cell.plants) {
				const { at, size, triangles } = each;
				const last = STEPS * (triangles.length - 1);
				const distance = Math.max(at.distanceTo(eye) - 0.5 * size, 0.01);
				each.ideal = cell.seen ? stepAt((modest * size) / (distance * high), triangles.length) : last;
				each.wanted = each.fine.length > 0 ? Math.max(STEPS, each.ideal) : each.ideal;
				if (!cell.seen) continue;
				const level = Math.floor(each.wanted / STEPS);
				count += triangles[level] + (each.wanted > STEPS * level ? triangles[level + 1] : 0);
			}
		}
		return count;
	}
}
