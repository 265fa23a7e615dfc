/**
 * The plants of a stand as they are drawn: in as few draws as there are finishes and times at which plants came, each at the level that
 * its size in the view asks for, those of cells out of sight not at all.
 */
import { Box3, Frustum, Group, Matrix4, type MeshStandardMaterial, type PerspectiveCamera, Vector3 } from "three";
import type { Material } from "../../../plant/material";
import type { PackedMesh } from "../../../plant/packed_mesh";
import type { LightUniforms } from "../../../scene/light_shader";
import { matrixOf } from "../../../scene/part_meshes";
import type { Member } from "../../model";
import { plantsOf } from "../parts";
import type { StandPlant } from "../stand_plant";
import { Batch, type Slot } from "./batch";
import { crowdMaterial, finishOf } from "./crowd_material";
import { shownAt } from "./level_choice";

/** Cells along each side of the ground. */
const CELLS = 12;
/** Of more different plants than these the finest level is for files alone: on the graphics card it would take as much as all others. */
const MOST_FINE = 250;
/** Triangles in a view, at the most; as many again may throw shadows. */
const MOST_TRIANGLES = 1_400_000;
/** So many times at the most all is made coarser for one view. */
const TRIES = 6;

interface Standing {
	readonly plant: number;
	readonly at: Vector3;
	/** As large as this, metres. */
	readonly size: number;
	readonly slots: readonly Slot[];
	/** Of each level. */
	readonly triangles: readonly number[];
	shown: string;
}

interface Cell {
	readonly box: Box3;
	readonly plants: Standing[];
}

export class Crowd {
	readonly group = new Group();
	readonly #light: LightUniforms;
	readonly #materials = new Map<string, MeshStandardMaterial>();
	#batches: Batch[] = [];
	#cells: Cell[] = [];
	#standing: Standing[] = [];
	#places: StandPlant["places"] | undefined;
	#known = new Set<Member>();
	#marked: number | undefined;
	/** The finest level drawn. */
	#first = 0;
	/** What all sizes are multiplied by, so that not too much is drawn. */
	#modest = 1;
	#triangles = 0;

	constructor(light: LightUniforms) {
		this.#light = light;
	}

	/** Triangles in the last view, without shadows. */
	get triangles(): number {
		return this.#triangles;
	}

	/** Shows a stand: of the one shown before, only what has come since is added. */
	show(stand: StandPlant): void {
		if (stand.places !== this.#places || [...this.#known].some((member) => !stand.members.includes(member)))
			this.#begin(stand);
		const fresh = stand.members.flatMap((member, index) =>
			member && !this.#known.has(member) ? [{ member, index }] : [],
		);
		if (fresh.length > 0) this.#add(stand, fresh);
	}

	/** Settles what is drawn of each for an eye there. */
	aim(camera: PerspectiveCamera): void {
		this.group.updateWorldMatrix(true, false);
		const view = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
		const frustum = new Frustum().setFromProjectionMatrix(view);
		const seen = this.#cells.map(({ box }) => !box.isEmpty() && frustum.intersectsBox(box));
		const high = 2 * Math.tan((camera.fov * Math.PI) / 360);
		// Settled for each view anew: no further frame may come to make up for the last one.
		this.#modest = 1;
		this.#triangles = this.#count(seen, camera.position, high);
		for (let tries = 0; this.#triangles > MOST_TRIANGLES && tries < TRIES; tries++) {
			this.#modest *= Math.min(0.75, Math.max(0.5, Math.sqrt(MOST_TRIANGLES / this.#triangles)));
			this.#triangles = this.#count(seen, camera.position, high);
		}
		for (const [i, { plants }] of this.#cells.entries()) {
			for (const each of plants) {
				if (seen[i]) this.#show(each, camera.position, high);
				else if (each.shown !== "") this.#set(each, -1, 1, "");
			}
		}
	}

	/** Lights one up; none where undefined. */
	mark(plant: number | undefined): void {
		for (const which of [this.#marked, plant]) {
			const found = this.#standing.find((each) => each.plant === which);
			if (found) found.shown = "changed";
		}
		this.#marked = plant;
	}

	dispose(): void {
		this.#clear();
		for (const material of this.#materials.values()) material.dispose();
		this.group.removeFromParent();
	}

	#begin({ places, ground, memberOf }: StandPlant): void {
		this.#clear();
		this.#places = places;
		this.#first = new Set(memberOf).size > MOST_FINE ? 1 : 0;
		this.#cells = Array.from({ length: CELLS * CELLS }, () => ({ box: new Box3(), plants: [] }));
		this.#cellAt = (x, z) => {
			const cell = (value: number, length: number) =>
				Math.min(CELLS - 1, Math.max(0, Math.floor(CELLS * (value / length + 0.5))));
			return this.#cells[CELLS * cell(z, ground.depth) + cell(x, ground.width)];
		};
	}

	#cellAt: (x: number, z: number) => Cell = () => ({ box: new Box3(), plants: [] });

	#clear(): void {
		for (const batch of this.#batches) batch.dispose();
		this.#batches = [];
		this.#cells = [];
		this.#standing = [];
		this.#known = new Set();
		this.#marked = undefined;
	}

	/** One batch a finish, of all that has come. */
	#add(stand: StandPlant, fresh: readonly { member: Member; index: number }[]): void {
		const plants = plantsOf(stand);
		const rows = fresh.map(({ member, index }) => ({
			member,
			plants: plants[index],
			layers: layersOf(member, this.#first),
		}));
		const finishes = new Map<string, { layers: Layer[]; instances: number }>();
		for (const { plants: there, layers } of rows) {
			for (const layer of layers) {
				const finish = finishes.get(layer.finish) ?? { layers: [], instances: 0 };
				finishes.set(layer.finish, finish);
				finish.layers.push(layer);
				finish.instances += there.length;
			}
		}
		const batches = new Map<string, Batch>();
		for (const [finish, { layers, instances }] of finishes) {
			const meshes = new Set(layers.flatMap(({ levels }) => levels.filter((mesh) => mesh !== undefined)));
			const batch = new Batch([...meshes], instances, this.#materialOf(finish, layers[0]));
			this.group.add(batch.object);
			this.#batches.push(batch);
			batches.set(finish, batch);
		}
		for (const { member, plants: there, layers } of rows) {
			this.#known.add(member);
			for (const plant of there) this.#stand(stand, plant, member, layers, batches);
		}
	}

	#stand(
		{ places }: StandPlant,
		plant: number,
		{ extent }: Member,
		layers: readonly Layer[],
		batches: Map<string, Batch>,
	): void {
		// There is nothing of it to draw, nor to count.
		if (layers.length === 0) return;
		const scale = places.scale[plant];
		const place = matrixOf(places.transforms, plant);
		const [x, y, z] = places.at.subarray(3 * plant, 3 * plant + 3);
		const [low, high, out] = [y + scale * extent.low, y + scale * extent.high, scale * extent.out];
		const cell = this.#cellAt(x, z);
		cell.box.union(new Box3(new Vector3(x - out, low, z - out), new Vector3(x + out, high, z + out)));
		const slots = layers.map(({ finish, levels, material }) =>
			(batches.get(finish) as Batch).add(levels, place, material.colour),
		);
		const triangles = Array.from({ length: layers[0]?.levels.length ?? 0 }, (_, level) =>
			layers.reduce((sum, { levels }) => sum + (levels[level]?.indices.length ?? 0) / 3, 0),
		);
		const size = Math.max(high - low, 2 * out);
		const standing = { plant, at: new Vector3(x, 0.5 * (low + high), z), size, slots, triangles, shown: "" };
		cell.plants.push(standing);
		this.#standing.push(standing);
	}

	#materialOf(finish: string, { material, coloured }: Layer): MeshStandardMaterial {
		const known = this.#materials.get(finish) ?? crowdMaterial(material, coloured, this.#light);
		this.#materials.set(finish, known);
		return known;
	}

	#shownOf({ at, size, triangles }: Standing, eye: Vector3, high: number) {
		const distance = Math.max(at.distanceTo(eye) - 0.5 * size, 0.01);
		return shownAt((this.#modest * size) / (distance * high), triangles.length);
	}

	#count(seen: readonly boolean[], eye: Vector3, high: number): number {
		let count = 0;
		for (const [i, { plants }] of this.#cells.entries()) {
			if (!seen[i]) continue;
			for (const each of plants) {
				const { level, share } = this.#shownOf(each, eye, high);
				count += each.triangles[level] + (share < 1 ? each.triangles[level + 1] : 0);
			}
		}
		return count;
	}

	#show(each: Standing, eye: Vector3, high: number): void {
		const { level, share } = this.#shownOf(each, eye, high);
		const shown = `${level} ${share}`;
		if (shown !== each.shown) this.#set(each, level, share, shown);
	}

	#set(each: Standing, level: number, share: number, shown: string): void {
		const bright = each.plant === this.#marked ? 1.9 : 1;
		for (const slot of each.slots) slot.batch.show(slot, level, share, bright);
		each.shown = shown;
	}
}

/** A member's meshes of one material, from its finest level to its coarsest. */
interface Layer {
	readonly finish: string;
	readonly material: Material;
	readonly coloured: boolean;
	readonly levels: readonly (PackedMesh | undefined)[];
}

function layersOf({ levels }: Member, first: number): Layer[] {
	const drawn = levels.length > first + 1 ? levels.slice(first) : levels;
	const layers: Layer[] = [];
	for (const material of new Set(drawn.flatMap((level) => level.map((each) => each.material)))) {
		const meshes = drawn.map((level) => level.find((each) => each.material === material)?.mesh);
		const coloured = meshes.some((mesh) => mesh?.colours !== undefined);
		layers.push({ finish: finishOf(material, coloured), material, coloured, levels: meshes });
	}
	return layers;
}
