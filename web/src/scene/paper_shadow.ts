import { LinearFilter, type PerspectiveCamera, Scene, Vector3, type WebGLRenderer, WebGLRenderTarget } from "three";
import type { LightRig } from "./light";
import { spreadOf } from "./light";

/** Pixels along the target's shorter side; the shadow is soft, so more would show nothing new. */
const RESOLUTION = 104;

/**
 * The shadow on the paper, drawn small and read back by the backdrop. The paper faces the viewer at depth `paper` (view
 * space, negative); the shadow goes there along the lamp's direction and is as soft as it has come far.
 */
export class PaperShadow {
	/** What casts: meshes whose materials, made with `uniforms`, lay them on the paper, white light to black. */
	readonly root = new Scene();
	readonly uniforms = {
		paper: { value: -1 },
		/** Towards the lamp, in view space, and the tangent of its apparent radius. */
		lamp: { value: new Vector3(0, 0, 1) },
		spread: { value: 0.3 },
	};
	readonly #target = new WebGLRenderTarget(1, 1, {
		depthBuffer: false,
		magFilter: LinearFilter,
		minFilter: LinearFilter,
	});

	/** What has been drawn: the light that is left. The channels are as many samples of the lamp, to be averaged. */
	get texture() {
		return this.#target.texture;
	}

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
		renderer.render(this.root, camera);
		renderer.setRenderTarget(null);
	}

	dispose(): void {
		this.#target.dispose();
	}
}
