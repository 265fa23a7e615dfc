import { DirectionalLight, Group, LightProbe, type PerspectiveCamera } from "three";
import { probeOf } from "./probe";
import type { StageLight } from "./stage_light";

/** The stage's light as three's own lamps, for its standard materials: both windows and the surroundings. */
export class StandardLights {
	readonly group = new Group();
	readonly #key = new DirectionalLight();
	readonly #rim = new DirectionalLight();
	readonly #sky = new LightProbe();

	constructor() {
		// A directional light shines from its position towards its target, which stays at the origin.
		this.group.add(this.#key, this.#rim, this.#sky);
	}

	/** Brings the lamps to the light, which turns with the viewer. */
	aim({ rig, uniforms }: StageLight, camera: PerspectiveCamera): void {
		this.#key.position.copy(uniforms.keyDirection.value);
		this.#key.color.setRGB(...rig.key.irradiance);
		this.#rim.position.copy(uniforms.rimDirection.value);
		this.#rim.color.setRGB(...rig.rim.irradiance);
		this.#sky.sh.copy(probeOf(rig.surroundings, camera.matrixWorld));
	}

	dispose(): void {
		this.group.removeFromParent();
		this.#key.dispose();
		this.#rim.dispose();
	}
}
