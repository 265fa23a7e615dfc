/** A game tree: the levels of detail of one tree, and its impostor, from the files of the archive. */
import {
	Box3,
	type BufferGeometry,
	type Group,
	Mesh,
	type MeshStandardMaterial,
	type Texture,
	TextureLoader,
} from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

/** The impostor of a tree: pictures of it from many directions, in a square grid. */
export interface Impostor {
	/** Pictures along an edge of the grid. */
	readonly frames: number;
	/** The middle of all pictures, metres. */
	readonly middle: readonly [number, number, number];
	/** Half the edge of a picture, metres. */
	readonly radius: number;
	/** Colour and coverage. */
	readonly colour: Texture;
	/** Red and green: x and y of the normal in the view of the picture, 0 … 1 for −1 … 1. */
	readonly surface: Texture;
}

/** A mesh of one level. */
export interface TreePart {
	/** In metres, in the coordinates of the tree. */
	readonly geometry: BufferGeometry;
	/** As `GLTFLoader` makes it. */
	readonly material: MeshStandardMaterial;
}

/** The description in the JSON of the archive. */
interface TreeDescription {
	/** The least share of the view's area at which each level is drawn. */
	readonly levels?: readonly { readonly screenCoverage: number }[];
	readonly impostor?: Omit<Impostor, "colour" | "surface"> & { readonly colour: string; readonly surface: string };
}

/** Properties of a tree that its GLB does not have. */
export interface TreeOptions {
	/** The pictures that are drawn in place of the last level, or after it if the GLB has only one. */
	readonly impostor?: Impostor | undefined;
	/** The least size of each level in the view, as a share of the view's height; the last level has no limit. */
	readonly sizes?: readonly number[] | undefined;
}

const LEVEL = /_LOD(\d)$/;

/** One kind of tree for a `Forest`. */
export class GameTree {
	/** The parts of each level, the finest first, without the level that the impostor replaces. */
	readonly levels: readonly (readonly TreePart[])[];
	/** The pictures that are drawn where the tree is small; undefined if there are none. */
	readonly impostor: Impostor | undefined;
	/** The least size of each level in the view, as a share of the view's height; undefined where not described. */
	readonly sizes: readonly number[] | undefined;
	/** Height above the ground, metres. */
	readonly height: number;
	/** Radius of a sphere that contains the tree, metres. */
	readonly radius: number;

	/**
	 * Takes the levels of a loaded GLB: the objects named `…_LOD0`, `…_LOD1` and so on. A file without such names is a
	 * tree with one level.
	 * @param gltf - as `GLTFLoader` returns it; the scene with the most levels is used
	 */
	constructor({ scenes }: { scenes: readonly Group[] }, { impostor, sizes }: TreeOptions = {}) {
		const all = scenes.map(levelsIn).sort((one, other) => other.length - one.length)[0] ?? [];
		this.levels = impostor && all.length > 1 ? all.slice(0, -1) : all;
		this.impostor = impostor;
		this.sizes = sizes;
		const box = new Box3();
		for (const { geometry } of this.levels[0] ?? []) {
			geometry.computeBoundingBox();
			box.union(geometry.boundingBox as Box3);
		}
		this.height = box.max.y;
		this.radius = 0.5 * box.min.distanceTo(box.max);
	}

	/**
	 * Loads a GLB and, if it exists, the JSON of the same name beside it with the sizes of the levels and the pictures of
	 * the impostor.
	 * @param address - of the GLB
	 * @throws Error if the GLB cannot be loaded
	 */
	static async load(address: string): Promise<GameTree> {
		const [gltf, options] = await Promise.all([new GLTFLoader().loadAsync(address), loadOptions(address)]);
		return new GameTree(gltf, options);
	}
}

/** Returns the parts of each level of a scene; all parts as one level if it has none. */
function levelsIn(scene: Group): TreePart[][] {
	scene.updateMatrixWorld(true);
	const levels: TreePart[][] = [];
	const single: TreePart[] = [];
	scene.traverse((object) => {
		if (!(object instanceof Mesh)) return;
		const level = levelOf(object);
		const { geometry, material } = object;
		const part = { geometry: geometry.clone().applyMatrix4(object.matrixWorld), material };
		if (level === undefined) {
			if (!object.name.startsWith("UCX_")) single.push(part);
			return;
		}
		levels[level] ??= [];
		levels[level].push(part);
	});
	const found = levels.filter((parts) => parts !== undefined);
	return found.length > 0 ? found : [single];
}

/** Returns the level of an object by its name or that of a parent. */
function levelOf(object: Mesh["parent"]): number | undefined {
	for (let at = object; at; at = at.parent) {
		const found = LEVEL.exec(at.userData.name ?? at.name);
		if (found) return Number(found[1]);
	}
	return undefined;
}

/** Loads the properties that the JSON beside a GLB describes, if there is one. */
async function loadOptions(address: string): Promise<TreeOptions> {
	const place = new URL(address, globalThis.location?.href);
	place.pathname = place.pathname.replace(/\.glb$/, ".json");
	const response = await fetch(place);
	// Some servers answer with a page if a file does not exist.
	if (!response.ok || !response.headers.get("content-type")?.includes("json")) return {};
	const { levels, impostor }: TreeDescription = await response.json();
	const sizes = levels?.slice(0, -1).map(({ screenCoverage }) => Math.sqrt(screenCoverage));
	if (!impostor) return { sizes };
	const loader = new TextureLoader();
	const picture = (name: string) => loader.loadAsync(new URL(encodeURIComponent(name), place).href);
	const [colour, surface] = await Promise.all([picture(impostor.colour), picture(impostor.surface)]);
	const { frames, middle, radius } = impostor;
	return { sizes, impostor: { frames, middle, radius, colour, surface } };
}
