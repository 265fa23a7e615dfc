import { DirectionalLight, Group, LightProbe, type PerspectiveCamera, Vector2, Vector3 } from "three";
import { probeOf } from "./probe";
import type { StageLight } from "./stage_light";
import type { WindUniforms } from "./wind_shader";

/** Size of the shadow map and radius of its blur, in pixels: the window is a large lamp. */
const SHADOW_PIXELS = 1024;
const SHADOW_BLUR = 4;

/** Far end of the shadow's range with ground, in radii: enough for a light 16° over the horizon. */
const FAR_GROUND = 9;

interface Ball {
	centre: Vector3;
	radius: number;
}

/** Sphere for a scene without shadows: the lamp is then at the distance of its direction's length. */
const NOWHERE: Ball = { centre: new Vector3(), radius: 0.5 };

/** The stage's light as three.js lights, for its standard materials: both windows and the surroundings. */
export class StandardLights {
	readonly group = new Group();
	readonly #key = new DirectionalLight();
	readonly #rim = new DirectionalLight();
	readonly #sky = new LightProbe();

	/** Whether shadows also fall on the ground below the ball. Set it before `shade`. */
	onGround = false;
	#shaded: Ball | undefined;
	/** Phase of the wind when the shadow was last drawn. */
	readonly #beat = new Vector2();

	constructor() {
		// A directional light shines from its position towards its target.
		this.group.add(this.#key, this.#rim, this.#sky);
	}

	/** Makes the key light cast shadows within a sphere. Meshes set `castShadow` and `receiveShadow` themselves. */
	shade(ball: Ball): void {
		this.#shaded = ball;
		const { shadow } = this.#key;
		this.#key.castShadow = ball.radius > 0;
		// The shadow is drawn again only after changes of the light or of the plant, not in every frame.
		shadow.autoUpdate = false;
		shadow.needsUpdate = true;
		shadow.mapSize.set(SHADOW_PIXELS, SHADOW_PIXELS);
		shadow.radius = SHADOW_BLUR;
		shadow.normalBias = (4 * ball.radius) / SHADOW_PIXELS;
		const { camera } = shadow;
		camera.left = camera.bottom = -ball.radius;
		camera.right = camera.top = ball.radius;
		camera.near = ball.radius;
		// A shadow on the ground is far behind the ball where the light is low.
		camera.far = (this.onGround ? FAR_GROUND : 3) * ball.radius;
		camera.updateProjectionMatrix();
	}

	/** Requests a new shadow map, because the graphics card has lost it. */
	restored(): void {
		this.#key.shadow.needsUpdate = true;
	}

	/**
	 * Aims the lamps with the stage's light, which turns with the viewer.
	 * @param wind wind that moves the casting objects, if any
	 */
	aim({ rig, uniforms }: StageLight, camera: PerspectiveCamera, wind?: WindUniforms): void {
		const beat = wind?.windBeat.value ?? this.#beat;
		if (!this.#beat.equals(beat)) this.#key.shadow.needsUpdate = true;
		this.#beat.copy(beat);
		this.#aimKey(uniforms.keyDirection.value);
		this.#key.color.setRGB(...rig.key.irradiance);
		this.#rim.position.copy(uniforms.rimDirection.value);
		this.#rim.color.setRGB(...rig.rim.irradiance);
		this.#sky.sh.copy(probeOf(rig.surroundings, camera.matrixWorld));
	}

	/**
	 * Places the key lamp in a direction from the shaded ball, at twice its radius; the shadow map is drawn again only if
	 * the lamp has moved.
	 * @param towards unit vector to the light
	 */
	#aimKey(towards: Vector3): void {
		const { position, target, shadow } = this.#key;
		const { centre, radius } = this.#shaded ?? NOWHERE;
		const at = towards
			.clone()
			.multiplyScalar(2 * radius)
			.add(centre);
		if (at.distanceToSquared(position) > 1e-12 * radius * radius) shadow.needsUpdate = true;
		position.copy(at);
		target.position.copy(centre);
		target.updateMatrixWorld();
	}

	/** Removes the lights from their scene and frees the shadow map. */
	dispose(): void {
		this.group.removeFromParent();
		this.#key.dispose();
		this.#rim.dispose();
	}
}
