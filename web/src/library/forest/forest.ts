/**
 * A forest of game trees for three.js, with levels of detail, wind and impostors.
 *
 * @packageDocumentation
 */
import {
	BufferAttribute,
	type BufferGeometry,
	type Camera,
	DynamicDrawUsage,
	Frustum,
	Group,
	InstancedBufferAttribute,
	InstancedMesh,
	type Material,
	Matrix4,
	type PerspectiveCamera,
	Quaternion,
	Sphere,
	Vector3,
} from "three";
import { LEAST_SIZES, STEPS, stepAt } from "../../render/level_choice";
import type { GameTree, TreePart } from "./game_tree";
import { impostorGeometry, impostorMaterial } from "./impostor_material";
import { treeDepth, treeMaterial } from "./tree_material";
import { type ForestWind, forestWind } from "./wind";

export { GameTree, type Impostor, type TreeOptions, type TreePart } from "./game_tree";

/** The place of one tree. */
export interface TreePlace {
	/** Index in the list of kinds. */
	readonly tree: number;
	/** Metres. */
	readonly position: readonly [number, number, number];
	/** About the vertical axis, radians; 0 where absent. */
	readonly rotation?: number;
	/** 1 where absent. */
	readonly scale?: number;
}

/** Options of a forest. */
export interface ForestOptions {
	/**
	 * The least size at which each level is drawn, as a share of the view's height, from near to far. By default those of
	 * the tree's description, or else 0.75, 0.26 and 0.085.
	 */
	readonly sizes?: readonly number[];
	/** Strength of the wind: 0 is calm, 1 a fresh breeze; 0.5 where absent. */
	readonly wind?: number;
}

const UP = new Vector3(0, 1, 0);

/** All instances of one kind of tree at one level. */
class LevelMeshes {
	readonly meshes: InstancedMesh[];
	readonly #matrices: InstancedBufferAttribute;
	readonly #fades: InstancedBufferAttribute;
	#count = 0;

	constructor(count: number, parts: readonly { geometry: BufferGeometry; material: Material; depth?: Material }[]) {
		this.#matrices = new InstancedBufferAttribute(new Float32Array(16 * count), 16).setUsage(DynamicDrawUsage);
		this.#fades = new InstancedBufferAttribute(new Float32Array(count), 1).setUsage(DynamicDrawUsage);
		this.meshes = parts.map(({ geometry, material, depth }) => {
			geometry.setAttribute("instanceFade", this.#fades);
			const mesh = new InstancedMesh(geometry, material, 0);
			mesh.instanceMatrix = this.#matrices;
			mesh.frustumCulled = false;
			if (depth) {
				mesh.customDepthMaterial = depth;
				mesh.castShadow = true;
			}
			mesh.receiveShadow = true;
			return mesh;
		});
	}

	/** Removes all instances. */
	clear(): void {
		this.#count = 0;
	}

	/** Adds an instance. */
	add(matrices: Float32Array, place: number, fade: number): void {
		const { array } = this.#matrices;
		const [from, to] = [16 * place, 16 * this.#count];
		for (let k = 0; k < 16; k++) array[to + k] = matrices[from + k];
		this.#fades.array[this.#count++] = fade;
	}

	/** Shows the instances that have been added. */
	show(): void {
		for (const mesh of this.meshes) {
			mesh.count = this.#count;
			mesh.visible = this.#count > 0;
		}
		for (const attribute of [this.#matrices, this.#fades]) {
			attribute.clearUpdateRanges();
			attribute.addUpdateRange(0, this.#count * attribute.itemSize);
			attribute.needsUpdate = true;
		}
	}

	get count(): number {
		return this.#count;
	}
}

/**
 * Many trees of a few kinds. Each is drawn at the level that fits its size in the view, and beyond the last level as an
 * impostor: one draw call for each material of each kind and level. Call `update` before each frame.
 *
 * @example
 * ```js
 * const oak = await GameTree.load("oak.glb");
 * const forest = new Forest([oak], places);
 * scene.add(forest);
 * renderer.setAnimationLoop((time) => {
 * 	forest.update(camera, time / 1000);
 * 	renderer.render(scene, camera);
 * });
 * ```
 */
export class Forest extends Group {
	readonly #kinds: readonly GameTree[];
	readonly #places: readonly TreePlace[];
	readonly #levels: readonly (readonly LevelMeshes[])[];
	readonly #sizes: readonly (readonly number[])[];
	readonly #wind: ForestWind = forestWind();
	/** Of all places, in the coordinates of the forest. */
	readonly #matrices: Float32Array;
	/** Middle of each tree, and its radius. */
	readonly #spheres: Float32Array;

	/**
	 * @param kinds - the kinds of trees
	 * @param places - where each tree is; a tree keeps its place
	 * @throws RangeError if a place names no kind
	 */
	constructor(kinds: readonly GameTree[], places: readonly TreePlace[], options: ForestOptions = {}) {
		super();
		this.name = "Forest";
		this.#kinds = kinds;
		this.#places = places;
		this.#sizes = kinds.map(({ sizes }) => options.sizes ?? sizes ?? LEAST_SIZES);
		this.#wind.windStrength.value = options.wind ?? 0.5;
		const wrong = places.find(({ tree }) => !kinds[tree]);
		if (wrong) throw new RangeError(`There is no kind ${wrong.tree}: the forest has ${kinds.length} kinds.`);
		this.#levels = kinds.map((kind, index) => {
			const count = places.filter(({ tree }) => tree === index).length;
			return levelsOf(kind, count, this.#wind);
		});
		for (const { meshes } of this.#levels.flat()) if (meshes.length > 0) this.add(...meshes);
		this.#matrices = new Float32Array(16 * places.length);
		this.#spheres = new Float32Array(4 * places.length);
		for (const [index, place] of places.entries()) this.#arrange(index, place);
	}

	/** Computes the matrix and the sphere of a place. */
	#arrange(index: number, { tree, position, rotation = 0, scale = 1 }: TreePlace): void {
		const turn = new Quaternion().setFromAxisAngle(UP, rotation);
		new Matrix4()
			.compose(new Vector3(...position), turn, new Vector3(scale, scale, scale))
			.toArray(this.#matrices, 16 * index);
		const { height, radius } = this.#kinds[tree];
		const [x, y, z] = position;
		this.#spheres.set([x, y + 0.5 * scale * height, z, scale * radius], 4 * index);
	}

	/** Strength of the wind: 0 is calm, 1 a fresh breeze. */
	get wind(): number {
		return this.#wind.windStrength.value;
	}

	set wind(strength: number) {
		this.#wind.windStrength.value = strength;
	}

	/** Direction of the wind, in the coordinates of the forest; its length has no effect. */
	get windDirection(): Vector3 {
		return this.#wind.windDirection.value;
	}

	/**
	 * Chooses the level of each tree for a camera, and advances the wind.
	 * @param seconds - time of the wind
	 * @returns the number of trees at each level, the last one being the impostor, of all kinds together
	 */
	update(camera: PerspectiveCamera, seconds: number): number[] {
		this.#wind.windTime.value = seconds;
		this.updateWorldMatrix(true, false);
		camera.updateWorldMatrix(true, false);
		const eye = this.worldToLocal(new Vector3().setFromMatrixPosition(camera.matrixWorld));
		const frustum = frustumOf(camera, this.matrixWorld);
		const sphere = new Sphere();
		// Height of a tree at distance 1 as a share of the view's height.
		const zoom = camera.zoom / (2 * Math.tan((0.5 * Math.PI * camera.fov) / 180));
		for (const level of this.#levels.flat()) level.clear();
		for (const [index, { tree, scale = 1 }] of this.#places.entries()) {
			sphere.center.fromArray(this.#spheres, 4 * index);
			sphere.radius = this.#spheres[4 * index + 3];
			if (!frustum.intersectsSphere(sphere)) continue;
			const distance = Math.max(1e-3, eye.distanceTo(sphere.center) - 0.5 * sphere.radius);
			this.#draw(index, tree, (zoom * scale * this.#kinds[tree].height) / distance);
		}
		for (const level of this.#levels.flat()) level.show();
		const most = Math.max(0, ...this.#levels.map((levels) => levels.length));
		return Array.from({ length: most }, (_, k) =>
			this.#levels.reduce((sum, levels) => sum + (levels[k]?.count ?? 0), 0),
		);
	}

	/** Adds a tree to its level, and while it changes levels also to the next. */
	#draw(index: number, tree: number, size: number): void {
		const levels = this.#levels[tree];
		const step = stepAt(size, levels.length, this.#sizes[tree]);
		const level = Math.floor(step / STEPS);
		const next = (step % STEPS) / STEPS;
		levels[level].add(this.#matrices, index, next > 0 ? 1 - next : 1);
		// The complement of the same pattern, so that no pixel is empty.
		if (next > 0) levels[level + 1].add(this.#matrices, index, -(1 - next));
	}

	/** Frees the memory of the graphics card. The kinds can be used in another forest. */
	override dispose(): void {
		for (const { meshes } of this.#levels.flat()) {
			for (const mesh of meshes) {
				mesh.geometry.dispose();
				(mesh.material as Material).dispose();
				mesh.customDepthMaterial?.dispose();
				mesh.dispose();
			}
		}
		this.clear();
	}
}

/** Makes the meshes of all levels of a kind, and of its impostor. */
function levelsOf(kind: GameTree, count: number, wind: ForestWind): LevelMeshes[] {
	const levels = kind.levels.map((parts) => {
		return new LevelMeshes(
			count,
			parts.map(({ geometry, material }) => ({
				geometry: windGeometry(geometry),
				material: treeMaterial(material, wind, kind.height),
				depth: treeDepth(material, wind, kind.height),
			})),
		);
	});
	if (!kind.impostor) return levels;
	const impostor = { geometry: impostorGeometry(), material: impostorMaterial(kind.impostor) };
	return [...levels, new LevelMeshes(count, [impostor])];
}

/** Returns a geometry of its own for a forest, whose vertex colours are wind data; without them nothing moves. */
function windGeometry(source: TreePart["geometry"]): BufferGeometry {
	const geometry = source.clone();
	// COLOR_1, or COLOR_0 where the file has only one set of colours.
	const { color_1, color, position } = geometry.attributes;
	for (const name of ["color", "color_1"]) geometry.deleteAttribute(name);
	const calm = new Float32Array(4 * position.count).map((_, i) => (i % 4 === 3 ? 1 : 0));
	geometry.setAttribute("windData", color_1 ?? color ?? new BufferAttribute(calm, 4));
	return geometry;
}

/** Returns the frustum of a camera in the coordinates of a forest. */
function frustumOf(camera: Camera, forest: Matrix4): Frustum {
	const inverse = camera.matrixWorld.clone().invert();
	return new Frustum().setFromProjectionMatrix(camera.projectionMatrix.clone().multiply(inverse).multiply(forest));
}
