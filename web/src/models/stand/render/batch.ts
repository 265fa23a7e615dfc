/** Draws many meshes of one finish in one draw call: plants of a stand that arrived together. */
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
import { STEPS } from "../../../render/level_choice";
import { EDGE_NORMAL_SIZE, edgeNormalsOf } from "./edge_normals";

/** A plant's meshes of one material, by level of detail. */
export interface Slot {
	readonly batch: Batch;
	readonly colour: Colour;
	/** Geometry of each level in the batch; −1 where there is nothing to draw. */
	readonly geometries: readonly number[];
	/** Instances of the shown level and of the level that it fades to. */
	readonly now: number;
	readonly other: number;
}

const four = new Vector4();

export class Batch {
	readonly object: BatchedMesh;
	readonly #geometries = new Map<PackedMesh, number>();

	/**
	 * @param meshes all meshes, each once
	 * @param instances most plants, each in two levels
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
		// The crowd culls cells; culling and sorting single plants takes longer than drawing them.
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
	 * Adds a plant's meshes, invisible at first.
	 * @param place transform of unit meshes; its last row holds the data that crowd_material.ts reads there
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

	/**
	 * Shows the level of a step (level_choice.ts), maybe fading to the next level; hides the plant where the step is
	 * negative.
	 */
	show(slot: Slot, step: number, bright: number): void {
		const level = step < 0 ? -1 : Math.floor(step / STEPS);
		const faded = step < 0 ? 0 : step / STEPS - level;
		// The next level fades in before the other fades out: one is always complete, else thin stems would have holes.
		this.#setInstance(slot, slot.now, level, Math.min(1, 2 - 2 * faded), bright);
		this.#setInstance(slot, slot.other, faded > 0 ? level + 1 : -1, Math.min(1, 2 * faded), bright);
	}

	/**
	 * Shows one instance at a level, or hides it where the level is negative or has no mesh.
	 * @param instance index in the batch
	 * @param opacity share of the pixels that are drawn, for fading
	 * @param bright factor on the colour
	 */
	#setInstance({ geometries, colour }: Slot, instance: number, level: number, opacity: number, bright: number): void {
		const geometry = level < 0 ? -1 : (geometries[Math.min(level, geometries.length - 1)] ?? -1);
		this.object.setVisibleAt(instance, geometry >= 0);
		if (geometry < 0) return;
		if (this.object.getGeometryIdAt(instance) !== geometry) this.object.setGeometryIdAt(instance, geometry);
		this.object.setColorAt(instance, four.set(bright * colour[0], bright * colour[1], bright * colour[2], opacity));
	}

	/** Removes the batch from the scene and releases its graphics memory. */
	dispose(): void {
		this.object.removeFromParent();
		this.object.dispose();
	}
}

/**
 * Releases an attribute's memory after its upload to the GPU. The plants hold the data too: after a loss of context
 * the batch is rebuilt (`ModelRenderer.restored`). The array stays, with length 0, because its type is still needed.
 */
function releaseAfterUpload(attribute: BufferAttribute): void {
	attribute.onUpload(() => {
		attribute.array = attribute.array.slice(0, 0);
	});
}

/** Creates a geometry from packed arrays, which shaders read as −1 … 1 or 0 … 1. */
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
