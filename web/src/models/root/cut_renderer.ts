/** Renders a root in the ground: its parts, and the pit around them. */
import { Mesh, type PerspectiveCamera } from "three";
import { linear } from "../../plant/colour";
import type { Bodies } from "../../render/camera_fit";
import { MaterialCache } from "../../render/material_cache";
import type { ModelRenderer, RendererFactory, RendererStage, ViewRay } from "../../render/model_renderer";
import { boxOf, joined } from "../../render/part_bounds";
import { PartMeshes } from "../../render/part_meshes";
import { PartRenderer } from "../../render/part_renderer";
import { grownExtent } from "../particles/boundary/grown_extent";
import type { WoodenPlant } from "../particles/boundary/wooden_plant";
import { rootLayout } from "./layout";
import { rootParts } from "./root_parts";
import { buildPit, type PitBounds, pitHolds } from "./soil";
import type { RootSpecimen } from "./specimen";
import { ROOT_TABLE } from "./table";

class CutRenderer implements ModelRenderer<RootSpecimen, WoodenPlant> {
	readonly modes = ["whole"];
	readonly #stage: RendererStage;
	readonly #roots: PartRenderer<RootSpecimen, WoodenPlant>;
	readonly #materials: MaterialCache;
	#soil: PartMeshes | undefined;
	/** The bounds that the pit was built for, its points and its colour. */
	#pitBounds: PitBounds | undefined;
	#wallPoints: Float32Array = new Float32Array(0);
	#pitColour = "";
	#bounds: Bodies = { spheres: new Float32Array(0), points: new Float32Array(0) };

	constructor(stage: RendererStage) {
		this.#stage = stage;
		this.#roots = new PartRenderer(stage, rootParts);
		this.#materials = new MaterialCache(stage.light.uniforms);
	}

	/** Shows the root in its pit; the pit is rebuilt only if the root no longer fits, or the soil's colour changes. */
	show(grown: WoodenPlant, specimen: RootSpecimen): void {
		this.#roots.show(grown, specimen);
		const { spheres, points } = this.#roots.bounds();
		// Where the root is still growing, the pit is for the fully grown root.
		const bodies = { spheres, points: joined([points, grownExtent(rootLayout, ROOT_TABLE, specimen)]) };
		const box = boxOf(bodies);
		if (box.isEmpty()) {
			this.#removePit();
			this.#bounds = bodies;
			return;
		}
		const roots = reachOf(grown.segments.ends, { low: box.min.toArray(), high: box.max.toArray() });
		// Previews do not rebuild the pit for every particle that moves; they have no visibility of the sky.
		const preview = !grown.meshes.some(({ sky }) => sky);
		const { soil } = specimen.look;
		const fits = this.#pitBounds && (preview ? pitHolds(this.#pitBounds, roots) : sameBounds(this.#pitBounds, roots));
		if (!fits || soil !== this.#pitColour) this.#rebuildPit(roots, soil);
		this.#bounds = { spheres, points: joined([bodies.points, this.#wallPoints]) };
	}

	/**
	 * Replaces the pit.
	 * @param roots bounds of the roots that it must contain
	 * @param soil colour of the soil
	 */
	#rebuildPit(roots: PitBounds, soil: string): void {
		this.#removePit();
		this.#materials.change();
		const mesh = buildPit(roots, soil);
		const shape = { mesh, material: { name: "Soil", colour: linear(soil), roughness: 1 } };
		this.#soil = new PartMeshes([{ name: "Soil", shape }], this.#materials);
		// The near wall is not drawn, so it must not cast a shadow; shadows of roots on the far wall would look like
		// roots.
		for (const object of this.#soil.objects) object.castShadow = object.receiveShadow = false;
		this.#stage.root.add(...this.#soil.objects);
		this.#pitBounds = roots;
		this.#pitColour = soil;
		this.#wallPoints = mesh.positions;
	}

	/** Returns the bounds of root and pit. */
	bounds(): Bodies {
		return this.#bounds;
	}

	/** Uploads everything again after the graphics context was lost. */
	restored(): void {
		this.#roots.restored?.();
	}

	/** Prepares the next frame. */
	prepare(camera: PerspectiveCamera): void {
		this.#roots.prepare(camera);
	}

	/** Returns the number of the part that a ray from the camera hits; undefined where it hits none. */
	pick(ray: ViewRay): number | undefined {
		return this.#roots.pick(ray);
	}

	/** Highlights the part that `pick` returned; undefined ends the highlight. */
	mark(picked: number | undefined): void {
		this.#roots.mark(picked);
	}

	/** Does nothing: a root has a single mode. */
	setMode(): void {}

	/** Removes root and pit from the scene and releases their graphics memory. */
	dispose(): void {
		this.#removePit();
		this.#materials.dispose();
		this.#roots.dispose();
	}

	/** Removes the pit. */
	#removePit(): void {
		for (const object of this.#soil?.objects ?? []) if (object instanceof Mesh) object.removeFromParent();
		this.#soil?.dispose();
		this.#soil = undefined;
		this.#pitBounds = undefined;
	}
}

/** Returns whether two boxes are equal. */
function sameBounds(one: PitBounds, other: PitBounds): boolean {
	return [0, 1, 2].every((k) => one.low[k] === other.low[k] && one.high[k] === other.high[k]);
}

/**
 * Returns the bounds for the pit: all roots from the ground downwards, however deep they begin, without the stem above.
 * @param ends 6 numbers for each segment: start x y z, end x y z
 */
function reachOf(ends: Float32Array, { low, high }: PitBounds): PitBounds {
	const least = [...low] as [number, number, number];
	const most: [number, number, number] = [high[0], 0, high[2]];
	for (let at = 3; at < ends.length; at += 6) {
		for (let k = 0; k < 3; k++) least[k] = Math.min(least[k], ends[at + k]);
		for (let k = 0; k < 3; k += 2) most[k] = Math.max(most[k], ends[at + k]);
	}
	return { low: least, high: most };
}

export const cutRenderer: RendererFactory<RootSpecimen, WoodenPlant> = (stage) => new CutRenderer(stage);
