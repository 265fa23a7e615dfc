import { Group, type PerspectiveCamera, Scene, type WebGLRenderer } from "three";
import { Backdrop } from "./backdrop";
import type { Bodies } from "./camera_fit";
import type { Theme } from "./light";
import type { ModelRenderer, RendererFactory, ViewRay } from "./model_renderer";
import { PaperShadow } from "./paper_shadow";
import type { Drawable } from "./renderer";
import { StageLight } from "./stage_light";
import { Wind } from "./wind";

/** The renderer of a model, its light and the paper behind it: the whole scene, for any canvas. */
export class Stage<S, G> implements Drawable {
	readonly scene = new Scene();
	readonly wind = new Wind();
	readonly #light = new StageLight();
	readonly #shadow = new PaperShadow();
	readonly #backdrop = new Backdrop(this.#shadow.texture);
	#root = new Group();
	#renderer: ModelRenderer<S, G> | undefined;
	#mode = "";
	#marked: number | undefined;
	#whole: ReadonlySet<number> | undefined;
	#filled = false;

	readonly #changed: () => void;

	/** @param changed called when the renderer's drawing has changed by itself */
	constructor(changed: () => void = () => {}) {
		this.#changed = changed;
		this.scene.add(this.#backdrop.mesh);
	}

	/** Replaces the renderer. */
	use(make: RendererFactory<S, G>): void {
		this.#renderer?.dispose();
		this.#root.removeFromParent();
		this.#root = new Group();
		this.scene.add(this.#root);
		this.#renderer = make({
			root: this.#root,
			light: this.#light,
			shadow: this.#shadow,
			wind: this.wind.uniforms,
			changed: this.#changed,
		});
		this.#mode = this.#renderer.modes[0];
		this.#empty();
	}

	/** Draws the paper alone, and compiles all programs while the first plant is still growing. */
	readonly warmUp: Drawable = {
		draw: (renderer, camera, paper) => {
			this.#renderer?.warmUp?.();
			this.#fill();
			this.draw(renderer, camera, paper);
			this.#empty();
		},
	};

	/** Elevation of the first view over the horizon, degrees, if the renderer sets one. */
	get elevation(): number | undefined {
		return this.#renderer?.elevation;
	}

	/** Whether there is a plant to draw. */
	get filled(): boolean {
		return this.#filled;
	}

	/** @returns bounds that the view must contain */
	show(grown: G, specimen: S): Bodies {
		if (!this.#renderer) throw new Error("There is no figure to show a plant with: give the viewer one to use.");
		this.#renderer.show(grown, specimen);
		this.#marked = undefined;
		this.wind.fit(this.#renderer.sway?.());
		this.#fill();
		return this.#renderer.bounds();
	}

	pick(ray: ViewRay): number | undefined {
		return this.#filled ? this.#renderer?.pick(ray) : undefined;
	}

	/** @returns whether anything changed */
	mark(picked: number | undefined, whole?: ReadonlySet<number>): boolean {
		if (picked === this.#marked && (picked === undefined || whole === this.#whole)) return false;
		this.#marked = picked;
		this.#whole = whole;
		this.#renderer?.mark(picked, whole);
		return true;
	}

	get modes(): readonly string[] {
		return this.#renderer?.modes ?? [];
	}

	/** @returns whether anything changed */
	setMode(mode: string): boolean {
		if (mode === this.#mode || !this.modes.includes(mode)) return false;
		this.#mode = mode;
		this.#renderer?.setMode(mode);
		return true;
	}

	setTheme(theme: Theme): void {
		this.#light.setTheme(theme);
		this.#backdrop.setRig(this.#light.rig);
		this.#shadow.setRig(this.#light.rig);
	}

	/** Sets a flat black or white background; undefined restores the paper. */
	setGround(grey?: 0 | 1): void {
		if (grey === undefined) this.#backdrop.setRig(this.#light.rig);
		else this.#backdrop.setFlat(grey);
	}

	/**
	 * Draws the scene, after updating the parts that depend on the camera: light, shadows, order.
	 * @param paper distance of the paper from the eye
	 */
	draw(renderer: WebGLRenderer, camera: PerspectiveCamera, paper: number): void {
		this.#backdrop.setAspect(camera.aspect);
		this.#light.aim(camera);
		if (this.#filled) this.#renderer?.prepare(camera);
		this.#backdrop.setSky(this.#filled && this.#renderer?.within ? camera : undefined);
		this.#shadow.draw(renderer, camera, paper);
		renderer.render(this.scene, camera);
	}

	/**
	 * After a restored context, three.js uploads buffers, textures and programs again with the next draw, if the page
	 * still has them.
	 */
	restored(): void {
		this.#renderer?.restored?.();
	}

	/** Resolves when all parts of the plant are complete. */
	async whenFinished(): Promise<void> {
		await this.#renderer?.whenFinished?.();
	}

	dispose(): void {
		this.#renderer?.dispose();
		this.#backdrop.dispose();
		this.#shadow.dispose();
	}

	#fill(): void {
		this.#filled = true;
		this.#root.visible = true;
		this.#shadow.visible = true;
	}

	#empty(): void {
		this.#filled = false;
		this.#root.visible = false;
		this.#shadow.visible = false;
		this.#marked = undefined;
	}
}
