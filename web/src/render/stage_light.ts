import type { Matrix4, PerspectiveCamera } from "three";
import { type LightRig, rigOf, type WindowLight } from "./light";
import { aimLamps, lightUniforms, setRig } from "./light_shader";

/** Light of the stage: one rig at a time, which turns with the viewer. */
export class StageLight {
	/** One object for all surfaces, so that a change of light reaches all of them at once. */
	readonly uniforms = lightUniforms();
	/** The rig as set, and as the camera sees it. */
	#set: LightRig = rigOf("light");
	#rig: LightRig = this.#set;

	constructor() {
		setRig(this.uniforms, this.#rig);
	}

	/** The present light rig, in view space. */
	get rig(): LightRig {
		return this.#rig;
	}

	/** Sets the light. */
	setRig(rig: LightRig): void {
		this.#set = rig;
		this.#rig = rig;
		setRig(this.uniforms, rig);
	}

	/** Turns the lamps with the viewer, so that the plant turns in the light; those of a fixed rig stay. */
	aim(camera: PerspectiveCamera): void {
		if (this.#set.fixed) {
			this.#rig = rigInView(this.#set, camera.matrixWorldInverse);
			setRig(this.uniforms, this.#rig);
		}
		aimLamps(this.uniforms, this.#rig, camera.matrixWorld);
	}
}

/** Returns a rig with its directions turned from the plant's frame into view space. @param toView the camera's inverse matrix */
function rigInView(rig: LightRig, toView: Matrix4): LightRig {
	const turned = (window: WindowLight): WindowLight => ({
		...window,
		direction: window.direction.clone().transformDirection(toView),
	});
	return {
		...rig,
		key: turned(rig.key),
		rim: turned(rig.rim),
		surroundings: rig.surroundings.map((lobe) => ({ ...lobe, axis: lobe.axis.clone().transformDirection(toView) })),
	};
}
