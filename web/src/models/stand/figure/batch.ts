/** Many meshes of one finish in one draw: the plants of a stand that came together. */
import { BatchedMesh, BufferAttribute, BufferGeometry, Matrix4, type MeshStandardMaterial, Vector4 } from "three";
import type { Colour } from "../../../plant/colour";
import type { PackedMesh } from "../../../plant/packed_mesh";

/** A plant's meshes of one material: as many as it has levels. */
export interface Slot {
	readonly batch: Batch;
	readonly colour: Colour;
	/** What of the batch is each level; −1 where there is nothing to draw. */
	readonly geometries: readonly number[];
	/** The level shown, and the one that gives way to it or takes its place. */
	readonly now: number;
	readonly other: number;
	readonly place: Matrix4;
	/** How far a place of 1 reaches, of each level. */
	readonly units: readonly number[];
}

const scratch = new Matrix4();
const four = new Vector4();

export class Batch {
	readonly object: BatchedMesh;
	readonly #geometries = new Map<PackedMesh, number>();

	/**
	 * @param meshes all that will be drawn, each once
	 * @param instances how many at the most, each in two levels
	 */
	constructor(meshes: readonly PackedMesh[], instances: number, material: MeshStandardMaterial) {
		const vertices = meshes.reduce((sum, { sky }) => sum + sky.length, 0);
		const corners = meshes.reduce((sum, { indices }) => sum + indices.length, 0);
		this.object = new BatchedMesh(2 * instances, vertices, corners, material);
		// Cells are culled by the crowd; to cull and sort each plant takes longer than drawing it.
		this.object.perObjectFrustumCulled = false;
		this.object.sortObjects = false;
		this.object.frustumCulled = false;
		this.object.castShadow = true;
		this.object.receiveShadow = true;
		for (const mesh of meshes) this.#geometries.set(mesh, this.object.addGeometry(geometryOf(mesh)));
	}

	/** Makes room for a plant's meshes, not yet seen. */
	add(levels: readonly (PackedMesh | undefined)[], place: Matrix4, colour: Colour): Slot {
		const geometries = levels.map((mesh) => (mesh ? (this.#geometries.get(mesh) ?? -1) : -1));
		const any = Math.max(0, ...geometries);
		const [now, other] = [this.object.addInstance(any), this.object.addInstance(any)];
		for (const each of [now, other]) this.object.setVisibleAt(each, false);
		return { batch: this, colour, geometries, now, other, place, units: levels.map((mesh) => mesh?.unit ?? 1) };
	}

	/** Shows a level by its share, the next one by the rest; nothing where `level` is negative. */
	show(slot: Slot, level: number, share: number, bright: number): void {
		this.#set(slot, slot.now, level, share, bright);
		// Beyond 1: what the other leaves out.
		this.#set(slot, slot.other, share < 1 ? level + 1 : -1, 1 + share, bright);
	}

	#set(
		{ geometries, units, place, colour }: Slot,
		instance: number,
		level: number,
		share: number,
		bright: number,
	): void {
		const geometry = level < 0 ? -1 : (geometries[Math.min(level, geometries.length - 1)] ?? -1);
		this.object.setVisibleAt(instance, geometry >= 0);
		if (geometry < 0) return;
		const unit = units[Math.min(level, units.length - 1)];
		this.object.setGeometryIdAt(instance, geometry);
		this.object.setMatrixAt(instance, scratch.makeScale(unit, unit, unit).premultiply(place));
		this.object.setColorAt(instance, four.set(bright * colour[0], bright * colour[1], bright * colour[2], share));
	}

	dispose(): void {
		this.object.removeFromParent();
		this.object.dispose();
	}
}

function geometryOf({ positions, normals, sky, colours, indices }: PackedMesh): BufferGeometry {
	const geometry = new BufferGeometry();
	geometry.setAttribute("position", new BufferAttribute(positions, 3, true));
	geometry.setAttribute("normal", new BufferAttribute(normals, 3, true));
	geometry.setAttribute("sky", new BufferAttribute(sky, 1, true));
	if (colours) geometry.setAttribute("color", new BufferAttribute(colours, 3, true));
	geometry.setIndex(new BufferAttribute(indices, 1));
	return geometry;
}
