import type { PerspectiveCamera } from "three";
import { type LightRig, rigOf, type Theme } from "./light";
import { aimLamps, lightUniforms, setRig } from "./light_shader";

/** Light of the stage: one rig at a time, which turns with the viewer. */
export class StageLight {
	/** One object for all surfaces, so that a change of light reaches all of them at once. */
	readonly uniforms = lightUniforms();
	#rig: LightRig = rigOf("light");

	constructor() {
		setRig(this.uniforms, this.#rig);
	}

	/** The present light rig. */
	get rig(): LightRig {
		return this.#rig;
	}

	/** Sets the light of a colour scheme of the page. */
	setTheme(theme: Theme): void {
		this.#rig = rigOf(theme);
		setRig(this.uniforms, this.#rig);
	}

	/** Turns the lamps with the viewer, so that the plant turns in the light. */
	aim(camera: PerspectiveCamera): void {
		aimLamps(this.uniforms, this.#rig, camera.matrixWorld);
	}
}
