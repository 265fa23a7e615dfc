/**
 * Renders the plants of a stand with few draw calls: one per finish and arrival. Each plant has the level of detail
 * for its size in the view; plants in invisible cells have the coarsest level, because their shadows may be visible.
 */
import { Box3, Frustum, Group, Matrix4, type MeshStandardMaterial, type PerspectiveCamera, Vector3 } from "three";
import type { Material } from "../../../plant/material";
import type { PackedMesh } from "../../../plant/packed_mesh";
import { STEPS } from "../../../render/level_choice";
import type { LightUniforms } from "../../../render/light_shader";
import { matrixOf } from "../../../render/part_meshes";
import type { WindUniforms } from "../../../render/wind_shader";
import type { Member } from "../../model";
import { plantsOf } from "../parts";
import type { StandPlant } from "../stand_plant";
import { Batch } from "./batch";
import { crowdDepth, crowdMaterial, finishOf } from "./crowd_material";
import { Cells, type DrawnPlant, type FineMesh } from "./drawn_plant";

/**
 * With more members than this, only a few plants have their finest level: that of all would take as much memory as all
 * other levels.
 */
const MAX_FINE = 250;
/** Number of plants with their finest level in that case. */
const NEAREST = 12;
/** Most triangles in a view; as many again may cast shadows. */
const MAX_TRIANGLES = 1_400_000;
/** Most attempts per view to make all plants coarser. */
const TRIES = 6;
/** Factor on the colour of a marked plant. */
const MARKED = 1.9;

export class Crowd {
	readonly group = new Group();
	readonly #light: LightUniforms;
	readonly #wind: WindUniforms;
	readonly #depth = crowdDepth();
	readonly #materials = new Map<string, MeshStandardMaterial>();
	#batches: Batch[] = [];
	#cells = new Cells({ width: 1, depth: 1 });
	#drawnPlants: DrawnPlant[] = [];
	#places: StandPlant["places"] | undefined;
	#shownMembers = new Set<Member>();
	#marked: number | undefined;
	/** Whether only the nearest plants have their finest level, those plants, and a buffer for candidates. */
	#savesMemory = false;
	#refined: DrawnPlant[] = [];
	readonly #candidates: DrawnPlant[] = [];
	#triangles = 0;
	/** The last view: a frame with the same view needs no work. */
	readonly #view = new Matrix4();
	#isChosen = false;
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
		const current = new Set(stand.members);
		if (stand.places !== this.#places || [...this.#shownMembers].some((member) => !current.has(member)))
			this.#begin(stand);
		const plants = plantsOf(stand);
		const newMembers = stand.members.flatMap((member, index) =>
			member && plants[index] && !this.#shownMembers.has(member) ? [{ member, index }] : [],
		);
		if (newMembers.length > 0) this.#add(stand, plants, newMembers);
	}

	/** Chooses the level of detail of each plant for a camera, with at most MAX_TRIANGLES in view. */
	aim(camera: PerspectiveCamera): void {
		this.group.updateWorldMatrix(true, false);
		this.#next.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
		if (this.#isChosen && this.#next.equals(this.#view)) return;
		this.#isChosen = true;
		this.#frustum.setFromProjectionMatrix(this.#view.copy(this.#next));
		const viewHeight = 2 * Math.tan((camera.fov * Math.PI) / 360);
		// Chosen from scratch for each view: no later frame may come that corrects it.
		let sizeFactor = 1;
		this.#triangles = this.#cells.choose(this.#frustum, camera.position, viewHeight, sizeFactor);
		for (let tries = 0; this.#triangles > MAX_TRIANGLES && tries < TRIES; tries++) {
			sizeFactor *= Math.min(0.75, Math.max(0.5, Math.sqrt(MAX_TRIANGLES / this.#triangles)));
			this.#triangles = this.#cells.choose(this.#frustum, camera.position, viewHeight, sizeFactor);
		}
		if (this.#savesMemory) this.#refine(camera.position);
		for (const each of this.#drawnPlants) if (each.wanted !== each.shown) this.#showLevel(each);
	}

	/** Gives the nearest large plants their finest level, and takes it from all others. */
	#refine(eye: Vector3): void {
		const candidates = this.#candidates;
		candidates.length = 0;
		for (const each of this.#drawnPlants) if (each.ideal < STEPS && each.fine.length > 0) candidates.push(each);
		candidates.sort((one, other) => one.at.distanceToSquared(eye) - other.at.distanceToSquared(eye));
		if (candidates.length > NEAREST) candidates.length = NEAREST;
		for (const each of this.#refined) if (!candidates.includes(each)) this.#coarsen(each);
		for (const each of candidates) {
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
		this.#refined = [...candidates];
	}

	/** Removes the finest level of a plant. */
	#coarsen(each: DrawnPlant): void {
		for (const { batch } of each.near) batch.dispose();
		each.near = [];
	}

	/** Highlights a plant; none where undefined. */
	mark(plant: number | undefined): void {
		const before = this.#marked;
		this.#marked = plant;
		for (const each of this.#drawnPlants) if (each.plant === before || each.plant === plant) this.#showLevel(each);
	}

	/** Rebuilds everything after a loss of the graphics context. */
	restored(stand: StandPlant): void {
		const marked = this.#marked;
		this.#begin(stand);
		this.show(stand);
		this.mark(marked);
	}

	/** Removes the plants from the scene and releases their graphics memory. */
	dispose(): void {
		this.#clear();
		for (const material of this.#materials.values()) material.dispose();
		this.#depth.dispose();
		this.group.removeFromParent();
	}

	/** Prepares for the plants of another stand: removes all plants and divides the new ground into cells. */
	#begin({ places, ground, memberOf }: StandPlant): void {
		this.#clear();
		this.#places = places;
		this.#savesMemory = new Set(memberOf).size > MAX_FINE;
		this.#cells = new Cells(ground);
	}

	/** Removes all plants. */
	#clear(): void {
		for (const batch of this.#batches) batch.dispose();
		for (const each of this.#refined) this.#coarsen(each);
		this.#refined = [];
		this.#batches = [];
		this.#drawnPlants = [];
		this.#shownMembers = new Set();
		this.#marked = undefined;
	}

	/** Adds one batch per finish for all new members. */
	#add(stand: StandPlant, plants: readonly number[][], newMembers: readonly { member: Member; index: number }[]): void {
		this.#isChosen = false;
		const rows = newMembers.map(({ member, index }) => ({
			member,
			plants: plants[index],
			layers: layersOf(member, this.#savesMemory),
		}));
		// The layers of all members by their finish: each finish is one draw call.
		const finishes = new Map<string, { layers: Layer[]; instances: number }>();
		for (const { plants: itsPlants, layers } of rows) {
			for (const layer of layers) {
				const finish = finishes.get(layer.finish) ?? { layers: [], instances: 0 };
				finishes.set(layer.finish, finish);
				finish.layers.push(layer);
				finish.instances += itsPlants.length;
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
		for (const { member, plants: itsPlants, layers } of rows) {
			this.#shownMembers.add(member);
			for (const plant of itsPlants) this.#addPlant(stand, plant, member, layers, batches);
		}
	}

	/** Adds a plant to the batches of its cell of the ground, with its meshes at all levels of detail. */
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
		const [low, high, radius] = [y + scale * extent.low, y + scale * extent.high, scale * extent.out];
		// The cell's box contains all of its plants, and is used for culling.
		const cell = this.#cells.at(x, z);
		cell.box.union(new Box3(new Vector3(x - radius, low, z - radius), new Vector3(x + radius, high, z + radius)));
		const stem = stemOf(places, kinds, plant);
		const fine: FineMesh[] = [];
		const slots = layers.map((layer) => {
			const { finish, levels, spared } = layer;
			const { colour } = layer.material;
			const unit = (spared ?? levels.find((mesh) => mesh))?.unit ?? 1;
			const place = matrixOf(places.transforms, plant).scale(new Vector3(unit, unit, unit));
			// The matrix's last row is free: crowd_material.ts reads the stem's data there.
			for (const [row, value] of stem.entries()) place.elements[4 * row + 3] = value;
			if (spared) fine.push({ mesh: spared, material: this.#materialOf(finish, layer), place, colour });
			return (batches.get(finish) as Batch).add(levels, place, colour);
		});
		// Triangles of the plant at each level, for the limit of the view.
		const triangles = Array.from({ length: layers[0]?.levels.length ?? 0 }, (_, level) =>
			layers.reduce((sum, { levels, spared }) => {
				const mesh = level === 0 ? (spared ?? levels[0]) : levels[level];
				return sum + (mesh?.indices.length ?? 0) / 3;
			}, 0),
		);
		const size = Math.max(high - low, 2 * radius);
		const centre = new Vector3(x, 0.5 * (low + high), z);
		const steps = { shown: -1, wanted: -1, ideal: -1 };
		const drawnPlant: DrawnPlant = { plant, at: centre, size, slots, fine, near: [], triangles, ...steps };
		cell.plants.push(drawnPlant);
		this.#drawnPlants.push(drawnPlant);
	}

	/** Returns the material of a finish, created at the first use. */
	#materialOf(finish: string, { material, coloured }: Layer): MeshStandardMaterial {
		const known = this.#materials.get(finish) ?? crowdMaterial(material, coloured, this.#light, this.#wind);
		this.#materials.set(finish, known);
		return known;
	}

	/** Draws a plant at the level that was chosen for it, brighter where it is marked. */
	#showLevel(each: DrawnPlant): void {
		const bright = each.plant === this.#marked ? MARKED : 1;
		for (const slot of each.slots) slot.batch.show(slot, each.wanted, bright);
		for (const slot of each.near) slot.batch.show(slot, each.wanted, bright);
		each.shown = each.wanted;
	}
}

/**
 * Returns data for wind (crowd_material.ts): the vector from the plant to the base that it sways about, and the size of
 * the swaying plant, metres. Attached plants sway with their parent; sizes are the plan's, known before anything has
 * grown.
 */
export function stemOf({ at, parent, scale, kind }: StandPlant["places"], kinds: StandPlant["kinds"], plant: number) {
	const swaying = parent[plant] < 0 ? plant : parent[plant];
	const { width, height } = kinds[kind[swaying]].crown;
	const offset = (axis: number) => at[3 * swaying + axis] - at[3 * plant + axis];
	return [offset(0), offset(1), offset(2), scale[swaying] * Math.max(height, 0.5 * width)] as const;
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

/**
 * Returns a member's meshes as layers, one for each material, with their levels of detail.
 * @param savesMemory whether the finest of three or more levels is separated, because only near plants show it
 */
function layersOf({ levels }: Member, savesMemory: boolean): Layer[] {
	const layers: Layer[] = [];
	for (const material of new Set(levels.flatMap((level) => level.map((each) => each.material)))) {
		const meshes = levels.map((level) => level.find((each) => each.material === material)?.mesh);
		const coloured = meshes.some((mesh) => mesh?.colours !== undefined);
		const layer = { finish: finishOf(material, coloured), material, coloured };
		const spares = savesMemory && meshes.length > 2 && meshes.slice(1).some((mesh) => mesh);
		layers.push(
			spares ? { ...layer, levels: [undefined, ...meshes.slice(1)], spared: meshes[0] } : { ...layer, levels: meshes },
		);
	}
	return layers;
}
