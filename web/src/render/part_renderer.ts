import {
	BufferAttribute,
	BufferGeometry,
	Color,
	InstancedMesh,
	type Material,
	Mesh,
	MeshBasicMaterial,
	type MeshDepthMaterial,
	type PerspectiveCamera,
	Raycaster,
	Vector3,
} from "three";
import type { Picture } from "../plant/material";
import type { Part } from "../plant/part";
import type { Sway } from "../plant/sway";
import type { Bodies } from "./camera_fit";
import { MaterialCache, type TextureKind } from "./material_cache";
import { MeshShadow } from "./mesh_shadow";
import type { ModelRenderer, RendererFactory, RendererStage, ViewRay } from "./model_renderer";
import { ballOf, boundsOf, joined } from "./part_bounds";
import { PartMeshes, type PartObject } from "./part_meshes";
import { StandardLights } from "./standard_lights";
import { type CrownUniforms, windyDepth } from "./standard_material";

/** Emissive colour of a marked part. */
const MARK = new Color(0.22, 0.18, 0.12);
/** Overlay of the marked triangles: a colour that few plants have. */
const CELL = {
	color: 0x1f6fb0,
	transparent: true,
	opacity: 0.6,
	polygonOffset: true,
	polygonOffsetFactor: -2,
	polygonOffsetUnits: -2,
};
/** Overlay of the marked group, below the part's own. */
const WHOLE = { ...CELL, opacity: 0.22, polygonOffsetFactor: -1, polygonOffsetUnits: -1 };

/** Options of a `PartRenderer`. */
export interface PartRendererOptions {
	/** Whether the plant casts its shadow on the paper behind it; false if it stands on ground. True by default. */
	onPaper?: boolean;
	/** Crown that bends the normals of leaves outwards. */
	crown?: CrownUniforms;
}

/**
 * Renderer for models that consist of parts, with three's standard material and the stage's light. `pick` returns the
 * pick id of meshes with `pickIds`; other parts are numbered from the largest pick id on, in the order of the parts,
 * each instance separately.
 */
export class PartRenderer<S, G> implements ModelRenderer<S, G> {
	readonly modes = ["whole"];
	readonly #stage: RendererStage;
	readonly #parts: (grown: G, specimen: S) => Iterable<Part>;
	readonly #room: (specimen: S) => Float32Array;
	readonly #lights = new StandardLights();
	/** Shadow on the paper; undefined for plants that stand on ground. */
	readonly #shadow: MeshShadow | undefined;
	readonly #materials: MaterialCache;
	readonly #depth: MeshDepthMaterial;
	readonly #swayOf: (grown: G) => Sway | undefined;
	#sway: Sway | undefined;
	#shown: PartMeshes;
	/** One more than the largest pick id of any mesh. */
	#pickIdCount = 0;
	#bounds: Bodies = { spheres: new Float32Array(0), points: new Float32Array(0) };
	/** 3 × additional points that the view must contain. */
	#about: Float32Array = new Float32Array(0);
	#marks: Mesh<BufferGeometry, Material>[] = [];

	/**
	 * @param room returns additional points that the view must contain, metres
	 * @param swayOf returns a plant's motion in wind; without it, plants do not move
	 */
	constructor(
		stage: RendererStage,
		parts: (grown: G, specimen: S) => Iterable<Part>,
		room: (specimen: S) => Float32Array = () => new Float32Array(0),
		swayOf: (grown: G) => Sway | undefined = () => undefined,
		{ onPaper = true, crown }: PartRendererOptions = {},
	) {
		this.#stage = stage;
		this.#parts = parts;
		this.#room = room;
		this.#swayOf = swayOf;
		this.#materials = new MaterialCache(stage.light.uniforms, stage.wind, crown);
		this.#depth = windyDepth(stage.wind);
		this.#shown = new PartMeshes([], this.#materials);
		if (onPaper) this.#shadow = new MeshShadow(stage.shadow, stage.wind);
		else this.#lights.onGround = true;
		stage.root.add(this.#lights.group);
	}

	/** Replaces the drawn plant by another. */
	show(grown: G, specimen: S): void {
		this.#clear();
		const parts = [...this.#parts(grown, specimen)];
		this.#materials.change();
		this.#shown = new PartMeshes(parts, this.#materials);
		this.#pickIdCount = countPickIds(this.#shown.objects);
		for (const object of this.#shown.objects) {
			if (object.material.userData.blown) object.customDepthMaterial = this.#depth;
			this.#stage.root.add(object);
		}
		this.#sway = this.#swayOf(grown);
		this.#shadow?.set(this.#shown.objects, ({ userData }) => userData.blown);
		this.#bounds = boundsOf(parts);
		this.#about = this.#room(specimen);
		this.#lights.shade(ballOf(this.#bounds));
	}

	/** Returns the bounds of the drawn parts. */
	bounds(): Bodies {
		const { spheres, points } = this.#bounds;
		return { spheres, points: joined([points, this.#about]) };
	}

	/** Returns the movement in the wind; undefined where there is none. */
	sway(): Sway | undefined {
		return this.#sway;
	}

	/** Draws the shadow again, which a lost graphics context has erased. */
	restored(): void {
		this.#lights.restored();
	}

	/** Prepares the next frame for a camera. */
	prepare(camera: PerspectiveCamera): void {
		this.#lights.aim(this.#stage.light, camera, this.#stage.wind);
	}

	/**
	 * Returns the number of the part under a ray. Meshes with pick ids are numbered first, by their ids; then each other
	 * mesh or instance, in the order of drawing.
	 */
	pick({ origin, direction }: ViewRay): number | undefined {
		const ray = new Raycaster(new Vector3(...origin), new Vector3(...direction).normalize());
		const [hit] = ray.intersectObjects(this.#shown.objects, false);
		if (!hit) return undefined;
		const pickIds = pickIdsOf(hit.object as PartObject);
		if (pickIds) return pickIds[hit.faceIndex ?? 0];
		let before = this.#pickIdCount;
		for (const object of this.#shown.objects) {
			if (object === hit.object) break;
			if (!pickIdsOf(object)) before += countOf(object);
		}
		return before + (hit.instanceId ?? 0);
	}

	/**
	 * Highlights a part by its number from `pick`; undefined removes the highlight.
	 * @param whole pick ids that belong to the same part, highlighted more faintly
	 */
	mark(picked: number | undefined, whole: ReadonlySet<number> = new Set()): void {
		this.#unmark();
		if (picked === undefined) return;
		let left = picked - this.#pickIdCount;
		for (const object of this.#shown.objects) {
			const pickIds = pickIdsOf(object);
			if (pickIds) {
				this.#markTriangles(object, pickIds, (id) => id === picked, CELL);
				this.#markTriangles(object, pickIds, (id) => id !== picked && whole.has(id), WHOLE);
			} else if (left >= 0 && left < countOf(object)) this.#addMark(highlightOf(object, left));
			if (!pickIds) left -= countOf(object);
		}
	}

	/**
	 * Draws a copy of the triangles whose pick ids satisfy `which` over the mesh.
	 * @param by options of the overlay's material
	 */
	#markTriangles(
		{ geometry }: PartObject,
		pickIds: Uint32Array,
		which: (id: number) => boolean,
		by: typeof CELL,
	): void {
		if (!pickIds.some(which)) return;
		const mark = new Mesh(onlyOf(geometry, pickIds, which), new MeshBasicMaterial(by));
		mark.userData.own = true;
		this.#addMark(mark);
	}

	/** Adds a mark to the scene. */
	#addMark(mark: Mesh<BufferGeometry, Material>): void {
		this.#marks.push(mark);
		this.#stage.root.add(mark);
	}

	/** Replaces a picture of a part that is drawn with one. */
	setPicture(name: string, kind: TextureKind, picture: Picture): void {
		const found = this.#shown.objects.find((object) => object.name === name);
		if (found) this.#materials.setPicture(found.material, kind, picture);
	}

	/** Does nothing: there is one mode. */
	setMode(): void {}

	/** Removes the parts from the scene and releases their graphics memory. */
	dispose(): void {
		this.#clear();
		this.#materials.dispose();
		this.#depth.dispose();
		this.#shadow?.dispose();
		this.#lights.dispose();
	}

	/** Removes the plant and its marks from the scene. */
	#clear(): void {
		this.#unmark();
		for (const object of this.#shown.objects) object.removeFromParent();
		this.#shown.dispose();
		this.#shadow?.set([]);
	}

	/** Removes all marks; only overlays own their geometry, marked instances share it. */
	#unmark(): void {
		for (const mark of this.#marks) {
			mark.removeFromParent();
			mark.material.dispose();
			if (mark.userData.own) mark.geometry.dispose();
		}
		this.#marks = [];
	}
}

/** Returns the pick id of each triangle of a part; undefined if its mesh has none. */
const pickIdsOf = ({ userData }: PartObject): Uint32Array | undefined => userData.pickIds;

/** Returns one more than the largest pick id of any mesh. */
function countPickIds(objects: readonly PartObject[]): number {
	let count = 0;
	for (const object of objects) for (const id of pickIdsOf(object) ?? []) count = Math.max(count, id + 1);
	return count;
}

/** Returns a copy of a material that glows and is drawn in front of the original. */
function lightenedMaterial(material: PartObject["material"]): PartObject["material"] {
	const lightened = material.clone();
	lightened.emissive.copy(MARK);
	lightened.polygonOffset = true;
	lightened.polygonOffsetFactor = -1;
	lightened.polygonOffsetUnits = -1;
	return lightened;
}

/**
 * Returns a lightened copy of an object, drawn over it as a highlight; of an object with instances, a copy of one
 * instance.
 * @param index of the instance
 */
function highlightOf(object: PartObject, index: number): PartObject {
	const mark: PartObject = new Mesh(object.geometry, lightenedMaterial(object.material));
	if (object instanceof InstancedMesh) {
		object.getMatrixAt(index, mark.matrix);
		mark.matrix.decompose(mark.position, mark.quaternion, mark.scale);
	}
	return mark;
}

/**
 * Returns the triangles whose pick ids satisfy `which`, with vertices of their own: three.js deletes a geometry's
 * buffers with it, even if another geometry shares its attributes.
 */
function onlyOf(geometry: BufferGeometry, pickIds: Uint32Array, which: (id: number) => boolean): BufferGeometry {
	const indices = geometry.index?.array ?? [];
	/** Index of each vertex in the mark, in the order of first use. */
	const places = new Map<number, number>();
	const own: number[] = [];
	for (let corner = 0; corner < 3 * pickIds.length; corner++) {
		if (!which(pickIds[Math.floor(corner / 3)])) continue;
		const place = places.get(indices[corner]) ?? places.size;
		places.set(indices[corner], place);
		own.push(place);
	}
	const only = new BufferGeometry();
	for (const name of ["position", "normal"]) {
		const attribute = geometry.getAttribute(name);
		const values = new Float32Array(3 * places.size);
		for (const [vertex, place] of places)
			for (let axis = 0; axis < 3; axis++) values[3 * place + axis] = attribute.getComponent(vertex, axis);
		only.setAttribute(name, new BufferAttribute(values, 3));
	}
	only.setIndex(own);
	return only;
}

/** Returns the number of instances of a part; 1 for a single mesh. */
function countOf(object: PartObject): number {
	return object instanceof InstancedMesh ? object.count : 1;
}

/**
 * Returns the renderer of a model that consists of parts.
 * @param room returns additional points that the view must contain, metres
 * @param swayOf returns a plant's motion in wind
 */
export function partRenderer<S, G>(
	parts: (grown: G, specimen: S) => Iterable<Part>,
	room?: (specimen: S) => Float32Array,
	swayOf?: (grown: G) => Sway | undefined,
): RendererFactory<S, G> {
	return (stage) => new PartRenderer(stage, parts, room, swayOf);
}
