import { LinearFilter, type PerspectiveCamera, Scene, Vector3, type WebGLRenderer, WebGLRenderTarget } from "three";
import type { LightRig } from "./light";
import { spreadOf } from "./light";
import { SoftShadow } from "./soft_shadow";

/** Pixels along the target's shorter side; more would not be visible in a soft shadow. */
const RESOLUTION = 160;

/**
 * Shadow on the paper, drawn into a small texture for the backdrop. The paper faces the viewer at depth `paper` (view
 * space, negative); the shadow falls along the lamp's direction and is softer, the farther it has fallen.
 */
export class PaperShadow {
	/**
	 * Objects that draw soft shadows themselves: their materials, made with `uniforms`, draw onto the paper, from
	 * white for light to black.
	 */
	readonly root = new Scene();
	/** Objects that cast hard shadows, as from a point light; softened afterwards (`MeshShadow`). */
	readonly hard = new Scene();
	readonly uniforms = {
		paper: { value: -1 },
		/** Direction towards the lamp in view space, and the tangent of its apparent radius. */
		lamp: { value: new Vector3(0, 0, 1) },
		spread: { value: 0.3 },
	};
	readonly #soft = new SoftShadow();
	readonly #target = new WebGLRenderTarget(1, 1, {
		depthBuffer: false,
		magFilter: LinearFilter,
		minFilter: LinearFilter,
	});

	/** The remaining light, in each channel. */
	get texture() {
		return this.#target.texture;
	}

	/** Sets whether any shadow is drawn. */
	set visible(visible: boolean) {
		this.root.visible = this.hard.visible = visible;
	}

	/** Sets the direction of the shadow's light and its softness from a light rig. */
	setRig({ shadow, key }: LightRig): void {
		this.uniforms.lamp.value.copy(shadow.direction);
		this.uniforms.spread.value = spreadOf(key);
	}

	/**
	 * Draws the shadow as `camera` sees it.
	 * @param paper distance of the paper from the camera
	 */
	draw(renderer: WebGLRenderer, camera: PerspectiveCamera, paper: number): void {
		const height = camera.aspect >= 1 ? RESOLUTION : Math.round(RESOLUTION / camera.aspect);
		this.#target.setSize(Math.round(height * camera.aspect), height);
		this.uniforms.paper.value = -paper;
		renderer.setRenderTarget(this.#target);
		renderer.setClearColor(0xffffff, 1);
		renderer.clear();
		if (this.hard.visible && this.hard.children.length > 0)
			this.#soft.draw(renderer, this.hard, camera, this.uniforms.spread.value, this.#target);
		if (this.root.children.length > 0) renderer.render(this.root, camera);
		renderer.setRenderTarget(null);
	}

	/** Releases the graphics memory. */
	dispose(): void {
		this.#target.dispose();
		this.#soft.dispose();
	}
}
