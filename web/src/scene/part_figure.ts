import { Color, InstancedMesh, Mesh, type MeshDepthMaterial, type PerspectiveCamera, Raycaster, Vector3 } from "three";
import type { Picture } from "../plant/material";
import type { Part } from "../plant/part";
import type { Sway } from "../plant/sway";
import type { Bodies } from "./camera_fit";
import type { Figure, FigureMaker, FigureStage, Ray } from "./figure";
import { MeshShadow } from "./mesh_shadow";
import { ballOf, boundsOf, joined } from "./part_bounds";
import { PartMeshes, type PartObject } from "./part_meshes";
import { StandardLights } from "./standard_lights";
import { windyDepth } from "./standard_material";
import { type Drawn, Wardrobe } from "./wardrobe";

/** The light that marks a part. */
const MARK = new Color(0.22, 0.18, 0.12);

/**
 * The figure of any model that gives parts: drawn in three's standard material under the stage's light. `pick` counts what
 * is drawn in the order of the parts, each instance by itself.
 */
export class PartFigure<S, G> implements Figure<S, G> {
	readonly modes = ["whole"];
	readonly #stage: FigureStage;
	readonly #parts: (grown: G, specimen: S) => Iterable<Part>;
	readonly #room: (specimen: S) => Float32Array;
	readonly #lights = new StandardLights();
	readonly #shadow: MeshShadow;
	readonly #wardrobe: Wardrobe;
	readonly #depth: MeshDepthMaterial;
	readonly #swayOf: (grown: G) => Sway | undefined;
	#sway: Sway | undefined;
	#shown: PartMeshes;
	#bounds: Bodies = { spheres: new Float32Array(0), points: new Float32Array(0) };
	/** 3 × points that the view is to hold besides. */
	#about: Float32Array = new Float32Array(0);
	#mark: PartObject | undefined;

	/**
	 * @param room points that the view is to hold besides the parts, metres
	 * @param swayOf how wind moves a plant; where absent it stands still
	 */
	constructor(
		stage: FigureStage,
		parts: (grown: G, specimen: S) => Iterable<Part>,
		room: (specimen: S) => Float32Array = () => new Float32Array(0),
		swayOf: (grown: G) => Sway | undefined = () => undefined,
	) {
		this.#stage = stage;
		this.#parts = parts;
		this.#room = room;
		this.#swayOf = swayOf;
		this.#wardrobe = new Wardrobe(stage.light.uniforms, stage.wind);
		this.#depth = windyDepth(stage.wind);
		this.#shown = new PartMeshes([], this.#wardrobe);
		this.#shadow = new MeshShadow(stage.shadow, stage.wind);
		stage.root.add(this.#lights.group);
	}

	show(grown: G, specimen: S): void {
		this.#clear();
		const parts = [...this.#parts(grown, specimen)];
		this.#wardrobe.change();
		this.#shown = new PartMeshes(parts, this.#wardrobe);
		for (const object of this.#shown.objects) {
			if (object.material.userData.blown) object.customDepthMaterial = this.#depth;
			this.#stage.root.add(object);
		}
		this.#sway = this.#swayOf(grown);
		this.#shadow.lay(this.#shown.objects, ({ userData }) => userData.blown);
		this.#bounds = boundsOf(parts);
		this.#about = this.#room(specimen);
		this.#lights.shade(ballOf(this.#bounds));
	}

	bounds(): Bodies {
		const { spheres, points } = this.#bounds;
		return { spheres, points: joined([points, this.#about]) };
	}

	sway(): Sway | undefined {
		return this.#sway;
	}

	restored(): void {
		this.#lights.restored();
	}

	prepare(camera: PerspectiveCamera): void {
		this.#lights.aim(this.#stage.light, camera, this.#stage.wind);
	}

	pick({ origin, direction }: Ray): number | undefined {
		const ray = new Raycaster(new Vector3(...origin), new Vector3(...direction).normalize());
		const [hit] = ray.intersectObjects(this.#shown.objects, false);
		if (!hit) return undefined;
		let before = 0;
		for (const object of this.#shown.objects) {
			if (object === hit.object) break;
			before += countOf(object);
		}
		return before + (hit.instanceId ?? 0);
	}

	mark(picked: number | undefined): void {
		this.#unmark();
		let left = picked ?? -1;
		const found = this.#shown.objects.find((object) => {
			if (left < countOf(object)) return true;
			left -= countOf(object);
			return false;
		});
		if (!found || left < 0) return;
		const material = found.material.clone();
		material.emissive.copy(MARK);
		material.polygonOffset = true;
		material.polygonOffsetFactor = -1;
		material.polygonOffsetUnits = -1;
		this.#mark = new Mesh(found.geometry, material);
		if (found instanceof InstancedMesh) {
			found.getMatrixAt(left, this.#mark.matrix);
			this.#mark.matrix.decompose(this.#mark.position, this.#mark.quaternion, this.#mark.scale);
		}
		this.#stage.root.add(this.#mark);
	}

	/** Lays another picture on a part that is drawn with one. */
	lay(name: string, kind: Drawn, picture: Picture): void {
		const found = this.#shown.objects.find((object) => object.name === name);
		if (found) this.#wardrobe.lay(found.material, kind, picture);
	}

	setMode(): void {}

	dispose(): void {
		this.#clear();
		this.#wardrobe.dispose();
		this.#depth.dispose();
		this.#shadow.dispose();
		this.#lights.dispose();
	}

	#clear(): void {
		this.#unmark();
		for (const object of this.#shown.objects) object.removeFromParent();
		this.#shown.dispose();
		this.#shadow.lay([]);
	}

	#unmark(): void {
		this.#mark?.removeFromParent();
		this.#mark?.material.dispose();
		this.#mark = undefined;
	}
}

function countOf(object: PartObject): number {
	return object instanceof InstancedMesh ? object.count : 1;
}

/** The figure of a model that has none of its own. */
export function partFigure<S, G>(
	parts: (grown: G, specimen: S) => Iterable<Part>,
	room?: (specimen: S) => Float32Array,
	swayOf?: (grown: G) => Sway | undefined,
): FigureMaker<S, G> {
	return (stage) => new PartFigure(stage, parts, room, swayOf);
}
