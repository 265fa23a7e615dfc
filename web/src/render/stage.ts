import { Group, type Object3D, type PerspectiveCamera, Scene, type WebGLRenderer } from "three";
import { Backdrop } from "./backdrop";
import type { Bodies } from "./camera_fit";
import { rigOf, type Theme } from "./light";
import { type ModelRenderer, PAPER, type RendererFactory, type StageSetting, type ViewRay } from "./model_renderer";
import { PaperShadow } from "./paper_shadow";
import type { Drawable } from "./renderer";
import { StageLight } from "./stage_light";
import { Wind } from "./wind_shader";

/** The renderer of a model, its light and the paper behind it: the whole scene, for any canvas. */
export class Stage<S, G> implements Drawable {
	readonly scene = new Scene();
	/** Editing aids beside the plant, such as handles and boundaries. */
	readonly aids = new Group();
	readonly wind = new Wind();
	readonly #light = new StageLight();
	readonly #shadow = new PaperShadow();
	readonly #backdrop = new Backdrop(this.#shadow.texture);
	#root = new Group();
	#renderer: ModelRenderer<S, G> | undefined;
	#mode = "";
	#marked: number | undefined;
	#markedGroup: ReadonlySet<number> | undefined;
	#filled = false;
	readonly #setting: StageSetting = { ...PAPER };
	#wantsOutdoors = false;

	readonly #changed: () => void;

	/** @param changed called when the renderer's drawing has changed by itself */
	constructor(changed: () => void = () => {}) {
		this.#changed = changed;
		this.scene.add(this.#backdrop.mesh, this.aids);
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
			setting: this.#setting,
			wind: this.wind.uniforms,
			changed: this.#changed,
		});
		this.#mode = this.#renderer.modes[0];
		this.#applyLight();
		this.#hidePlant();
	}

	/** Draws the paper alone, and compiles all programs while the first plant is still growing. */
	readonly warmUp: Drawable = {
		draw: (renderer, camera, paper) => {
			this.#renderer?.warmUp?.();
			this.#showPlant();
			this.draw(renderer, camera, paper);
			this.#hidePlant();
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

	/**
	 * Shows a plant in place of the last one.
	 * @returns bounds that the view must contain
	 */
	show(grown: G, specimen: S): Bodies {
		if (!this.#renderer) throw new Error("There is no figure to show a plant with: give the viewer one to use.");
		this.#renderer.show(grown, specimen);
		this.#marked = undefined;
		this.wind.fit(this.#renderer.sway?.());
		this.#showPlant();
		return this.#renderer.bounds();
	}

	/** Returns the pick id of the first part along a ray; undefined if there is no plant or the ray hits nothing. */
	pick(ray: ViewRay): number | undefined {
		return this.#filled ? this.#renderer?.pick(ray) : undefined;
	}

	/**
	 * Marks a part, and softly its `group`, as `ModelRenderer.mark`.
	 * @returns whether anything changed
	 */
	mark(picked: number | undefined, group?: ReadonlySet<number>): boolean {
		if (picked === this.#marked && (picked === undefined || group === this.#markedGroup)) return false;
		this.#marked = picked;
		this.#markedGroup = group;
		this.#renderer?.mark(picked, group);
		return true;
	}

	/** Calls a function while the plant is shown without editing aids and marks. */
	plantAlone<Taken>(take: () => Taken): Taken {
		const [marked, group] = [this.#marked, this.#markedGroup];
		const { visible } = this.aids;
		this.mark(undefined);
		this.aids.visible = false;
		try {
			return take();
		} finally {
			this.aids.visible = visible;
			this.mark(marked, group);
		}
	}

	/** Modes of the renderer, the default first; empty without a renderer. */
	get modes(): readonly string[] {
		return this.#renderer?.modes ?? [];
	}

	/**
	 * Sets one of `modes`; other values are ignored.
	 * @returns whether anything changed
	 */
	setMode(mode: string): boolean {
		if (mode === this.#mode || !this.modes.includes(mode)) return false;
		this.#mode = mode;
		this.#renderer?.setMode(mode);
		return true;
	}

	/** Sets the light and the background of a colour scheme. */
	setTheme(theme: Theme): void {
		this.#setting.theme = theme;
		this.#applyLight();
	}

	/** Sets whether plants are shown outdoors; those that cannot be are shown on paper. */
	setOutdoors(on: boolean): void {
		this.#wantsOutdoors = on;
		this.#applyLight();
	}

	/** Samples per pixel of pictures, along each side. */
	get samples(): number {
		return this.#renderer?.samples ?? 1;
	}

	/** Least elevation of the first view outdoors, degrees, if the renderer sets one. */
	get outdoorElevation(): number | undefined {
		return this.#renderer?.outdoorElevation;
	}

	/** Height of the ground outdoors, metres; undefined on paper, and for plants that do not stand. */
	get groundLevel(): number | undefined {
		return this.#setting.outdoors ? this.#renderer?.groundLevel : undefined;
	}

	/** Sets a flat black or white background; undefined restores the paper or the sky. */
	setGround(grey?: 0 | 1): void {
		this.#setting.bare = grey !== undefined;
		if (grey === undefined) this.#backdrop.setRig(rigOf(this.#setting.theme));
		else this.#backdrop.setFlat(grey);
	}

	/** Sets the light and the background of the present theme, outdoors or not. */
	#applyLight(): void {
		const { theme } = this.#setting;
		const outdoors = this.#wantsOutdoors ? this.#renderer?.outdoorRig?.(theme) : undefined;
		this.#setting.outdoors = outdoors !== undefined;
		const rig = outdoors ?? rigOf(theme);
		this.#light.setRig(rig);
		this.#backdrop.setRig(rigOf(theme));
		this.#shadow.setRig(rig);
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
	 * Draws the plant at rest in the user's room, without paper, shadow, aids and marks.
	 * @param mark object that is drawn, too
	 * @param withPlant false draws the mark alone
	 */
	drawInRoom(renderer: WebGLRenderer, camera: PerspectiveCamera, mark: Object3D, withPlant: boolean): void {
		this.#setting.bare = true;
		this.#light.aim(camera);
		if (this.#filled) this.#renderer?.prepare(camera);
		this.#backdrop.mesh.visible = false;
		this.#root.visible = this.#filled && withPlant;
		this.scene.add(mark);
		try {
			this.plantAlone(() => this.wind.calm(() => renderer.render(this.scene, camera)));
		} finally {
			mark.removeFromParent();
			this.#backdrop.mesh.visible = true;
			this.#setting.bare = false;
			this.#root.visible = this.#filled;
		}
	}

	/**
	 * Restores GPU resources after a lost context. three.js itself uploads buffers, textures and programs again with the
	 * next draw, if the page still has them.
	 */
	restored(): void {
		this.#renderer?.restored?.();
	}

	/** Resolves when all parts of the plant are complete. */
	async whenFinished(): Promise<void> {
		await this.#renderer?.whenFinished?.();
	}

	/** Releases the graphics memory of everything on the stage. */
	dispose(): void {
		this.#renderer?.dispose();
		this.#backdrop.dispose();
		this.#shadow.dispose();
	}

	/** Makes the plant and its shadow visible. */
	#showPlant(): void {
		this.#filled = true;
		this.#root.visible = true;
		this.#shadow.visible = true;
	}

	/** Hides the plant and its shadow, and removes the mark. */
	#hidePlant(): void {
		this.#filled = false;
		this.#root.visible = false;
		this.#shadow.visible = false;
		this.#marked = undefined;
	}
}
