/** Many meshes of one finish in one draw: the plants of a stand that came together. */
import {
	BatchedMesh,
	BufferAttribute,
	BufferGeometry,
	type Matrix4,
	type MeshDepthMaterial,
	type MeshStandardMaterial,
	Vector4,
} from "three";
import type { Colour } from "../../../plant/colour";
import type { PackedMesh } from "../../../plant/packed_mesh";
import { EDGE_NORMAL_SIZE, edgeNormalsOf } from "./edge_normals";
import { STEPS } from "./level_choice";

/** A plant's meshes of one material: as many as it has levels. */
export interface Slot {
	readonly batch: Batch;
	readonly colour: Colour;
	/** What of the batch is each level; −1 where there is nothing to draw. */
	readonly geometries: readonly number[];
	/** The level shown, and the one that gives way to it or takes its place. */
	readonly now: number;
	readonly other: number;
}

const four = new Vector4();

export class Batch {
	readonly object: BatchedMesh;
	readonly #geometries = new Map<PackedMesh, number>();

	/**
	 * @param meshes all that will be drawn, each once
	 * @param instances how many at the most, each in two levels
	 */
	constructor(
		meshes: readonly PackedMesh[],
		instances: number,
		material: MeshStandardMaterial,
		depth: MeshDepthMaterial,
	) {
		const vertices = meshes.reduce((sum, { sky }) => sum + sky.length, 0);
		const corners = meshes.reduce((sum, { indices }) => sum + indices.length, 0);
		this.object = new BatchedMesh(2 * instances, vertices, corners, material);
		// Cells are culled by the crowd; to cull and sort each plant takes longer than drawing it.
		this.object.perObjectFrustumCulled = false;
		this.object.sortObjects = false;
		this.object.frustumCulled = false;
		this.object.castShadow = true;
		this.object.receiveShadow = true;
		this.object.customDepthMaterial = depth;
		for (const mesh of meshes) this.#geometries.set(mesh, this.object.addGeometry(geometryOf(mesh)));
		const { attributes, index } = this.object.geometry;
		for (const each of [...Object.values(attributes), index])
			if (each instanceof BufferAttribute) releaseAfterUpload(each);
	}

	/**
	 * Makes room for a plant's meshes, not yet seen.
	 * @param place of places of 1, and in its last row what crowd_material.ts reads there
	 */
	add(levels: readonly (PackedMesh | undefined)[], place: Matrix4, colour: Colour): Slot {
		const geometries = levels.map((mesh) => (mesh ? (this.#geometries.get(mesh) ?? -1) : -1));
		const any = Math.max(0, ...geometries);
		const [now, other] = [this.object.addInstance(any), this.object.addInstance(any)];
		for (const each of [now, other]) {
			this.object.setVisibleAt(each, false);
			this.object.setMatrixAt(each, place);
		}
		return { batch: this, colour, geometries, now, other };
	}

	/** Shows what `step` says (level_choice.ts): a level, and as far as it has given way the next one; nothing where it is negative. */
	show(slot: Slot, step: number, bright: number): void {
		const level = step < 0 ? -1 : Math.floor(step / STEPS);
		const gone = step < 0 ? 0 : step / STEPS - level;
		// First the one comes, then the other goes: there is always a whole one, or thin stems would have holes.
		this.#set(slot, slot.now, level, Math.min(1, 2 - 2 * gone), bright);
		this.#set(slot, slot.other, gone > 0 ? level + 1 : -1, Math.min(1, 2 * gone), bright);
	}

	#set({ geometries, colour }: Slot, instance: number, level: number, share: number, bright: number): void {
		const geometry = level < 0 ? -1 : (geometries[Math.min(level, geometries.length - 1)] ?? -1);
		this.object.setVisibleAt(instance, geometry >= 0);
		if (geometry < 0) return;
		if (this.object.getGeometryIdAt(instance) !== geometry) this.object.setGeometryIdAt(instance, geometry);
		this.object.setColorAt(instance, four.set(bright * colour[0], bright * colour[1], bright * colour[2], share));
	}

	dispose(): void {
		this.object.removeFromParent();
		this.object.dispose();
	}
}

/**
 * Once the graphics card has it, the page does without: the plants have it, too, and where the card loses it the batch is made anew
 * (`Figure.restored`). Of no length, for its kind is still asked for.
 */
function releaseAfterUpload(attribute: BufferAttribute): void {
	attribute.onUpload(() => {
		attribute.array = attribute.array.slice(0, 0);
	});
}

function geometryOf(mesh: PackedMesh): BufferGeometry {
	const { positions, normals, sky, colours, indices } = mesh;
	const geometry = new BufferGeometry();
	geometry.setAttribute("position", new BufferAttribute(positions, 3, true));
	geometry.setAttribute("normal", new BufferAttribute(normals, 3, true));
	geometry.setAttribute("sky", new BufferAttribute(sky, 1, true));
	geometry.setAttribute("edgeNormal", new BufferAttribute(edgeNormalsOf(mesh), EDGE_NORMAL_SIZE, true));
	if (colours) geometry.setAttribute("color", new BufferAttribute(colours, 3, true));
	geometry.setIndex(new BufferAttribute(indices, 1));
	return geometry;
}
