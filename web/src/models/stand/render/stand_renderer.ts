/** A stand on the stage: its ground, and the plants as they come. */
import { type PerspectiveCamera, Vector3 } from "three";
import type { Sway } from "../../../plant/sway";
import type { Bodies } from "../../../render/camera_fit";
import { MaterialCache } from "../../../render/material_cache";
import type { ModelRenderer, Ray, RendererStage } from "../../../render/model_renderer";
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
import { type Ball, shadedBall, walks } from "./shaded";

export class StandRenderer implements ModelRenderer<StandSpecimen, StandPlant> {
	readonly modes = ["whole"];
	readonly elevation = 24;
	readonly #stage: RendererStage;
	readonly #lights = new StandardLights();
	readonly #materials: MaterialCache;
	readonly #crowd: Crowd;
	readonly #ring = new MarkRing();
	readonly #ground: GroundRenderer;
	#trellis: PartMeshes;
	#stand: StandPlant | undefined;
	#whole: Ball = { centre: new Vector3(), radius: 0 };
	#shaded: Ball | undefined;
	readonly #towards = new Vector3();
	/** Where the lamps are while someone walks: key and rim. */
	#held: readonly [Vector3, Vector3] | undefined;
	#bounds: Bodies = { spheres: new Float32Array(0), points: new Float32Array(0) };

	constructor(stage: RendererStage) {
		this.#stage = stage;
		this.#materials = new MaterialCache(stage.light.uniforms);
		this.#crowd = new Crowd(stage.light.uniforms, stage.wind);
		this.#trellis = new PartMeshes([], this.#materials);
		this.#ground = new GroundRenderer(stage.light.uniforms);
		stage.root.add(this.#lights.group, this.#crowd.group, this.#ground.object, this.#ring.object);
	}

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
		this.#bounds = bodiesOf(grown);
		this.#whole = ballOf(this.#bounds);
		this.#shaded = undefined;
	}

	bounds(): Bodies {
		return this.#bounds;
	}

	get within(): boolean {
		return this.#held !== undefined;
	}

	/** How each plant sways is the crowd's: here is what says that it does. */
	sway(): Sway | undefined {
		const { centre, radius } = this.#whole;
		return radius > 0 ? { foot: centre.toArray(), up: 1, height: radius, reach: radius } : undefined;
	}

	restored(): void {
		this.#lights.restored();
		if (this.#stand) this.#crowd.restored(this.#stand);
	}

	prepare(camera: PerspectiveCamera): void {
		this.#hold(camera.position);
		this.#shade(camera);
		this.#lights.aim(this.#stage.light, camera);
		this.#crowd.aim(camera);
		this.#ring.aim(camera);
	}

	pick(ray: Ray): number | undefined {
		return this.#stand && firstPlantHit(this.#stand, ray);
	}

	mark(picked: number | undefined): void {
		this.#crowd.mark(picked);
		this.#ring.show(this.#stand, picked);
	}

	setMode(): void {}

	dispose(): void {
		this.#clear();
		this.#crowd.dispose();
		this.#ground.dispose();
		this.#ring.dispose();
		this.#materials.dispose();
		this.#lights.dispose();
	}

	/** Who turns the stand turns it in the light; who walks in it has the sun stay where it is. */
	#hold(eye: Vector3): void {
		const { keyDirection, rimDirection } = this.#stage.light.uniforms;
		if (!this.#stand || !walks(this.#stand, eye)) this.#held = undefined;
		else if (this.#held) {
			keyDirection.value.copy(this.#held[0]);
			rimDirection.value.copy(this.#held[1]);
		} else this.#held = [keyDirection.value.clone(), rimDirection.value.clone()];
	}

	/** Shadows are drawn where they are seen; anew where that is another place by a step. */
	#shade(camera: PerspectiveCamera): void {
		if (!this.#stand) return;
		const ball = shadedBall(this.#stand, this.#whole, camera.position, camera.getWorldDirection(this.#towards));
		if (this.#shaded?.radius === ball.radius && this.#shaded.centre.equals(ball.centre)) return;
		this.#shaded = ball;
		this.#lights.shade(ball);
	}

	#clear(): void {
		for (const object of this.#trellis.objects) object.removeFromParent();
		this.#trellis.dispose();
	}
}

/** The ground's corners, and a ball about each crown as the plan has it: the same before plants have come. */
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
