/**
 * Renders the plants of a stand with few draw calls: one per finish and arrival. Each plant has the level of detail
 * for its size in the view; plants in invisible cells have the coarsest level, because their shadows may be visible.
 */
import { Box3, Frustum, Group, Matrix4, type MeshStandardMaterial, type PerspectiveCamera, Vector3 } from "three";
import type { Material } from "../../../plant/material";
import type { PackedMesh } from "../../../plant/packed_mesh";
import type { LightUniforms } from "../../../render/light_shader";
import { matrixOf } from "../../../render/part_meshes";
import type { WindUniforms } from "../../../render/wind";
import type { Member } from "../../model";
import { plantsOf } from "../parts";
import type { StandPlant } from "../stand_plant";
import { Batch } from "./batch";
import { crowdDepth, crowdMaterial, finishOf } from "./crowd_material";
import { Cells, type DrawnPlant, type FineMesh } from "./drawn_plant";
import { STEPS } from "./level_choice";

/**
 * With more members than this, only a few plants have their finest level: that of all would take as much memory as all
 * other levels.
 */
const MOST_FINE = 250;
const NEAREST = 12;
/** Most triangles in a view; as many again may cast shadows. */
const MOST_TRIANGLES = 1_400_000;
/** Most attempts per view to make all plants coarser. */
const TRIES = 6;
const MARKED = 1.9;

export class Crowd {
	readonly group = new Group();
	readonly #light: LightUniforms;
	readonly #wind: WindUniforms;
	readonly #depth = crowdDepth();
	readonly #materials = new Map<string, MeshStandardMaterial>();
	#batches: Batch[] = [];
	#cells = new Cells({ width: 1, depth: 1 });
	#standing: DrawnPlant[] = [];
	#places: StandPlant["places"] | undefined;
	#known = new Set<Member>();
	#marked: number | undefined;
	/** Whether only the nearest plants have their finest level, those plants, and a buffer for candidates. */
	#sparing = false;
	#near: DrawnPlant[] = [];
	readonly #nearing: DrawnPlant[] = [];
	#triangles = 0;
	/** The last view: a frame with the same view needs no work. */
	readonly #view = new Matrix4();
	#settled = false;
	readonly #frustum = new Frustum();
	readonly #next = new Matrix4();

	constructor(light: LightUniforms, wind: WindUniforms) {
		this.#light = light;
		this.#wind = wind;
	}

	/** Triangles in the last view, without shadows. */
	get triangles(): number {
		return this.#triangles;
	}

	/** Shows a stand; of the same stand only new plants are added. */
	show(stand: StandPlant): void {
		const there = new Set(stand.members);
		if (stand.places !== this.#places || [...this.#known].some((member) => !there.has(member))) this.#begin(stand);
		const plants = plantsOf(stand);
		const fresh = stand.members.flatMap((member, index) =>
			member && plants[index] && !this.#known.has(member) ? [{ member, index }] : [],
		);
		if (fresh.length > 0) this.#add(stand, plants, fresh);
	}

	/** Chooses the level of detail of each plant for a camera. */
	aim(camera: PerspectiveCamera): void {
		this.group.updateWorldMatrix(true, false);
		this.#next.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
		if (this.#settled && this.#next.equals(this.#view)) return;
		this.#settled = true;
		this.#frustum.setFromProjectionMatrix(this.#view.copy(this.#next));
		const high = 2 * Math.tan((camera.fov * Math.PI) / 360);
		// Chosen from scratch for each view: no later frame may come that corrects it.
		let modest = 1;
		this.#triangles = this.#cells.choose(this.#frustum, camera.position, high, modest);
		for (let tries = 0; this.#triangles > MOST_TRIANGLES && tries < TRIES; tries++) {
			modest *= Math.min(0.75, Math.max(0.5, Math.sqrt(MOST_TRIANGLES / this.#triangles)));
			this.#triangles = this.#cells.choose(this.#frustum, camera.position, high, modest);
		}
		if (this.#sparing) this.#refine(camera.position);
		for (const each of this.#standing) if (each.wanted !== each.shown) this.#set(each);
	}

	/** Gives the nearest large plants their finest level, and takes it from all others. */
	#refine(eye: Vector3): void {
		const nearing = this.#nearing;
		nearing.length = 0;
		for (const each of this.#standing) if (each.ideal < STEPS && each.fine.length > 0) nearing.push(each);
		nearing.sort((one, other) => one.at.distanceToSquared(eye) - other.at.distanceToSquared(eye));
		if (nearing.length > NEAREST) nearing.length = NEAREST;
		for (const each of this.#near) if (!nearing.includes(each)) this.#coarsen(each);
		for (const each of nearing) {
			each.wanted = each.ideal;
			this.#triangles += each.triangles[0];
			if (each.near.length > 0) continue;
			each.near = each.fine.map(({ mesh, material, place, colour }) => {
				const batch = new Batch([mesh], 1, material, this.#depth);
				this.group.add(batch.object);
				return batch.add([mesh, undefined], place, colour);
			});
			each.shown = -1;
		}
		this.#near = [...nearing];
	}

	#coarsen(each: DrawnPlant): void {
		for (const { batch } of each.near) batch.dispose();
		each.near = [];
	}

	/** Highlights a plant; none where undefined. */
	mark(plant: number | undefined): void {
		const before = this.#marked;
		this.#marked = plant;
		for (const each of this.#standing) if (each.plant === before || each.plant === plant) this.#set(each);
	}

	/** Rebuilds everything after a loss of the graphics context. */
	restored(stand: StandPlant): void {
		const marked = this.#marked;
		this.#begin(stand);
		this.show(stand);
		this.mark(marked);
	}

	dispose(): void {
		this.#clear();
		for (const material of this.#materials.values()) material.dispose();
		this.#depth.dispose();
		this.group.removeFromParent();
	}

	#begin({ places, ground, memberOf }: StandPlant): void {
		this.#clear();
		this.#places = places;
		this.#sparing = new Set(memberOf).size > MOST_FINE;
		this.#cells = new Cells(ground);
	}

	#clear(): void {
		for (const batch of this.#batches) batch.dispose();
		for (const each of this.#near) this.#coarsen(each);
		this.#near = [];
		this.#batches = [];
		this.#standing = [];
		this.#known = new Set();
		this.#marked = undefined;
	}

	/** Adds one batch per finish for all new members. */
	#add(stand: StandPlant, plants: readonly number[][], fresh: readonly { member: Member; index: number }[]): void {
		this.#settled = false;
		const rows = fresh.map(({ member, index }) => ({
			member,
			plants: plants[index],
			layers: layersOf(member, this.#sparing),
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
			const batch = new Batch([...meshes], instances, this.#materialOf(finish, layers[0]), this.#depth);
			this.group.add(batch.object);
			this.#batches.push(batch);
			batches.set(finish, batch);
		}
		for (const { member, plants: there, layers } of rows) {
			this.#known.add(member);
			for (const plant of there) this.#addPlant(stand, plant, member, layers, batches);
		}
	}

	#addPlant(
		{ places, kinds }: StandPlant,
		plant: number,
		{ extent }: Member,
		layers: readonly Layer[],
		batches: Map<string, Batch>,
	): void {
		// A plant without meshes is neither drawn nor counted.
		if (layers.length === 0) return;
		const scale = places.scale[plant];
		const [x, y, z] = places.at.subarray(3 * plant, 3 * plant + 3);
		const [low, high, out] = [y + scale * extent.low, y + scale * extent.high, scale * extent.out];
		const cell = this.#cells.at(x, z);
		cell.box.union(new Box3(new Vector3(x - out, low, z - out), new Vector3(x + out, high, z + out)));
		const stem = stemOf(places, kinds, plant);
		const fine: FineMesh[] = [];
		const slots = layers.map((layer) => {
			const { finish, levels, spared } = layer;
			const { colour } = layer.material;
			const unit = (spared ?? levels.find((mesh) => mesh))?.unit ?? 1;
			const place = matrixOf(places.transforms, plant).scale(new Vector3(unit, unit, unit));
			for (const [row, value] of stem.entries()) place.elements[4 * row + 3] = value;
			if (spared) fine.push({ mesh: spared, material: this.#materialOf(finish, layer), place, colour });
			return (batches.get(finish) as Batch).add(levels, place, colour);
		});
		const triangles = Array.from({ length: layers[0]?.levels.length ?? 0 }, (_, level) =>
			layers.reduce((sum, { levels, spared }) => {
				const mesh = level === 0 ? (spared ?? levels[0]) : levels[level];
				return sum + (mesh?.indices.length ?? 0) / 3;
			}, 0),
		);
		const size = Math.max(high - low, 2 * out);
		const at = new Vector3(x, 0.5 * (low + high), z);
		const steps = { shown: -1, wanted: -1, ideal: -1 };
		const standing: DrawnPlant = { plant, at, size, slots, fine, near: [], triangles, ...steps };
		cell.plants.push(standing);
		this.#standing.push(standing);
	}

	#materialOf(finish: string, { material, coloured }: Layer): MeshStandardMaterial {
		const known = this.#materials.get(finish) ?? crowdMaterial(material, coloured, this.#light, this.#wind);
		this.#materials.set(finish, known);
		return known;
	}

	#set(each: DrawnPlant): void {
		const bright = each.plant === this.#marked ? MARKED : 1;
		for (const slot of each.slots) slot.batch.show(slot, each.wanted, bright);
		for (const slot of each.near) slot.batch.show(slot, each.wanted, bright);
		each.shown = each.wanted;
	}
}

/**
 * Data for wind (crowd_material.ts): the vector from the plant to the base that it sways about, and the size of the
 * swaying plant. Attached plants sway with their parent; sizes are the plan's, known before anything has grown.
 */
export function stemOf({ at, parent, scale, kind }: StandPlant["places"], kinds: StandPlant["kinds"], plant: number) {
	const of = parent[plant] < 0 ? plant : parent[plant];
	const { width, height } = kinds[kind[of]].crown;
	const from = (axis: number) => at[3 * of + axis] - at[3 * plant + axis];
	return [from(0), from(1), from(2), scale[of] * Math.max(height, 0.5 * width)] as const;
}

/** A member's meshes of one material, from the finest level to the coarsest. */
interface Layer {
	readonly finish: string;
	readonly material: Material;
	readonly coloured: boolean;
	/** Levels; the finest is undefined where it is in `spared`. */
	readonly levels: readonly (PackedMesh | undefined)[];
	readonly spared?: PackedMesh | undefined;
}

/** @param sparing whether the finest of three or more levels is separated */
function layersOf({ levels }: Member, sparing: boolean): Layer[] {
	const layers: Layer[] = [];
	for (const material of new Set(levels.flatMap((level) => level.map((each) => each.material)))) {
		const meshes = levels.map((level) => level.find((each) => each.material === material)?.mesh);
		const coloured = meshes.some((mesh) => mesh?.colours !== undefined);
		const layer = { finish: finishOf(material, coloured), material, coloured };
		const spares = sparing && meshes.length > 2 && meshes.slice(1).some((mesh) => mesh);
		layers.push(
			spares ? { ...layer, levels: [undefined, ...meshes.slice(1)], spared: meshes[0] } : { ...layer, levels: meshes },
		);
	}
	return layers;
}
