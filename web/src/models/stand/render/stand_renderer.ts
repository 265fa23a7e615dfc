/** Renders a stand: its ground, and its plants as they arrive. */
import { type PerspectiveCamera, Vector3 } from "three";
import { linear } from "../../../plant/colour";
import type { Footing } from "../../../plant/footing";
import type { Sway } from "../../../plant/sway";
import type { Bodies } from "../../../render/camera_fit";
import { MaterialCache } from "../../../render/material_cache";
import type { ModelRenderer, RendererStage, ViewRay } from "../../../render/model_renderer";
import { outdoorRig } from "../../../render/outdoor/outdoor_light";
import { Scenery } from "../../../render/outdoor/scenery";
import { ballOf } from "../../../render/part_bounds";
import { PartMeshes } from "../../../render/part_meshes";
import { StandardLights } from "../../../render/standard_lights";
import { groundParts } from "../parts";
import type { StandSpecimen } from "../specimen";
import type { StandPlant } from "../stand_plant";
import { Crowd } from "./crowd";
import { GroundRenderer } from "./ground_renderer";
import { MarkRing } from "./mark_ring";
import { firstPlantHit } from "./plant_hit";
import { isWalking, type StandBall, shadedBall } from "./shaded";

export class StandRenderer implements ModelRenderer<StandSpecimen, StandPlant> {
	readonly modes = ["whole"];
	readonly elevation = 24;
	readonly outdoorRig = outdoorRig;
	/** Low enough for a strip of sky, and high enough to look over the first row. */
	readonly outdoorElevation = 9;
	readonly #stage: RendererStage;
	readonly #lights = new StandardLights();
	readonly #materials: MaterialCache;
	readonly #crowd: Crowd;
	readonly #ring = new MarkRing();
	readonly #ground: GroundRenderer;
	/** The meadow and the sky about the stand, outdoors. */
	readonly #scenery: Scenery;
	#trellis: PartMeshes;
	#stand: StandPlant | undefined;
	#wholeBall: StandBall = { centre: new Vector3(), radius: 0 };
	#shaded: StandBall | undefined;
	readonly #viewDirection = new Vector3();
	/** Directions of key and rim light while the user walks. */
	#heldLight: readonly [Vector3, Vector3] | undefined;
	#bounds: Bodies = { spheres: new Float32Array(0), points: new Float32Array(0) };

	constructor(stage: RendererStage) {
		this.#stage = stage;
		this.#materials = new MaterialCache(stage.light.uniforms);
		this.#crowd = new Crowd(stage.light.uniforms, stage.wind);
		this.#trellis = new PartMeshes([], this.#materials);
		this.#ground = new GroundRenderer(stage.light.uniforms);
		this.#scenery = new Scenery(stage, { patch: false });
		this.#lights.onGround = true;
		stage.root.add(this.#lights.group, this.#crowd.group, this.#ground.object, this.#ring.object);
	}

	/** Replaces the drawn stand; called again whenever more of its plants have arrived. */
	show(grown: StandPlant, specimen: StandSpecimen): void {
		this.mark(undefined);
		this.#clear();
		this.#stand = grown;
		this.#materials.change();
		const [ground, ...trellis] = groundParts(grown, specimen);
		const { width, depth } = grown.ground;
		const rim = grown.soil?.rim ?? new Float32Array((grown.meshes[0]?.positions.length ?? 0) / 3);
		this.#ground.show(ground, rim, Math.min(width, depth));
		this.#trellis = new PartMeshes(trellis, this.#materials);
		for (const object of this.#trellis.objects) this.#stage.root.add(object);
		this.#crowd.show(grown);
		this.#scenery.show(meadowOf(grown), linear(specimen.look.soil));
		this.#bounds = bodiesOf(grown);
		this.#wholeBall = ballOf(this.#bounds);
		this.#shaded = undefined;
	}

	/** Returns the bounds of the whole stand. */
	bounds(): Bodies {
		return this.#bounds;
	}

	/** Height of the meadow about the stand, metres; undefined without a stand. */
	get groundLevel(): number | undefined {
		return this.#scenery.level;
	}

	/** Whether the camera is inside the stand, at a walker's eye level. */
	get within(): boolean {
		return this.#heldLight !== undefined;
	}

	/**
	 * Returns a movement of the whole stand, so that the stage animates it; the crowd then moves each plant. Undefined
	 * without a stand.
	 */
	sway(): Sway | undefined {
		const { centre, radius } = this.#wholeBall;
		return radius > 0 ? { foot: centre.toArray(), up: 1, height: radius, reach: radius } : undefined;
	}

	/** Uploads everything again after the graphics context was lost. */
	restored(): void {
		this.#lights.restored();
		if (this.#stand) this.#crowd.restored(this.#stand);
	}

	/** Prepares the next frame for a camera: light, shadows, levels of detail and the ring. */
	prepare(camera: PerspectiveCamera): void {
		this.#holdLight(camera.position);
		this.#shade(camera);
		this.#lights.aim(this.#stage.light, camera);
		this.#crowd.aim(camera);
		this.#ring.aim(camera);
		this.#scenery.aim(camera);
	}

	/** Returns the plant that a ray from the camera hits first; undefined where it hits none. */
	pick(ray: ViewRay): number | undefined {
		return this.#stand && firstPlantHit(this.#stand, ray);
	}

	/** Highlights a plant; undefined ends the highlight. */
	mark(picked: number | undefined): void {
		this.#crowd.mark(picked);
		this.#ring.show(this.#stand, picked);
	}

	/** Does nothing: a stand has a single mode. */
	setMode(): void {}

	/** Removes the stand from the scene and releases its graphics memory. */
	dispose(): void {
		this.#clear();
		this.#crowd.dispose();
		this.#ground.dispose();
		this.#scenery.dispose();
		this.#ring.dispose();
		this.#materials.dispose();
		this.#lights.dispose();
	}

	/** Fixes the light's direction in the stand while the user walks; in other views the stand turns in the light. */
	#holdLight(eye: Vector3): void {
		const { keyDirection, rimDirection } = this.#stage.light.uniforms;
		// Outdoors the sun stands still anyway.
		if (this.#stage.setting.outdoors || !this.#stand || !isWalking(this.#stand, eye)) this.#heldLight = undefined;
		else if (this.#heldLight) {
			keyDirection.value.copy(this.#heldLight[0]);
			rimDirection.value.copy(this.#heldLight[1]);
		} else this.#heldLight = [keyDirection.value.clone(), rimDirection.value.clone()];
	}

	/** Redraws the shadows where the shaded sphere has moved by a step. */
	#shade(camera: PerspectiveCamera): void {
		if (!this.#stand) return;
		const ball = shadedBall(
			this.#stand,
			this.#wholeBall,
			camera.position,
			camera.getWorldDirection(this.#viewDirection),
		);
		if (this.#shaded?.radius === ball.radius && this.#shaded.centre.equals(ball.centre)) return;
		this.#shaded = ball;
		this.#lights.shade(ball);
	}

	/** Removes the posts and wires. */
	#clear(): void {
		for (const object of this.#trellis.objects) object.removeFromParent();
		this.#trellis.dispose();
	}
}

/** Returns the footing of the meadow about a stand: level with the lowest of its ground, without stems and shade. */
function meadowOf({ ground }: StandPlant): Footing {
	const reach = 0.5 * Math.hypot(ground.width, ground.depth);
	return { centre: [0, -0.5 * ground.relief, 0], stems: [], reach, height: 1, cover: 0 };
}

/**
 * Returns the bounds: the ground's corners and a sphere around each crown as planned, so that they do not change as
 * plants arrive.
 */
function bodiesOf({ ground, places, kinds }: StandPlant): Bodies {
	const [x, z, y] = [0.5 * ground.width, 0.5 * ground.depth, 0.5 * ground.relief];
	const points = Float32Array.of(x, y, z, -x, y, z, x, y, -z, -x, y, -z, x, -y, z, -x, -y, -z);
	const spheres = new Float32Array(4 * places.count);
	for (let i = 0; i < places.count; i++) {
		const { width, height } = kinds[places.kind[i]].crown;
		const radius = 0.25 * places.scale[i] * Math.min(width, height);
		const high = places.parent[i] < 0 ? places.scale[i] * height : 0;
		spheres.set([places.at[3 * i], places.at[3 * i + 1] + high - radius, places.at[3 * i + 2], radius], 4 * i);
	}
	return { spheres, points };
}
