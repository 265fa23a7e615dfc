import { type Object3D, type PerspectiveCamera, Vector3 } from "three";
import { CameraController, type Gaze, type ViewName } from "./camera_controller";
import { type BoundingProfile, boundingProfileOf, lowestOf } from "./camera_fit";
import { type Frame, FrameLoop } from "./frame_loop";
import type { Theme } from "./light";
import type { RendererFactory, SceneVector, ViewRay } from "./model_renderer";
import { type Drawable, Renderer } from "./renderer";
import type { Size } from "./size";
import { Stage } from "./stage";

export interface ViewerOptions {
	/** Disables gliding and damping. */
	reducedMotion?: boolean;
	theme?: Theme;
	/** Ignores pointers: for pictures. */
	still?: boolean;
	/** Checks shaders for errors, which takes time: for developers. */
	checked?: boolean;
	/** Shared renderer, which the caller owns; absent: the view has a renderer of its own on its canvas. */
	renderer?: Renderer;
	events?: ViewerEvents;
}

/** Events of a viewer. */
export interface ViewerEvents {
	/** Once, after the first draw with a plant. */
	firstDraw?(): void;
	/** After every draw: overlays may have to follow the plant. */
	drawn?(): void;
	/** The graphics context was lost; the canvas is blank until `contextRestored`. */
	contextLost?(): void;
	contextRestored?(): void;
}

/**
 * View of a lit plant on a canvas, with orbiting, zooming, picking and pictures. Draws only after changes. The viewer
 * depends on no model: `use` sets the renderer that draws the plants.
 * @typeParam S the specimen
 * @typeParam G the plant grown from it
 */
export class Viewer<S, G> {
	readonly #canvas: HTMLCanvasElement;
	readonly #events: ViewerEvents;
	#drawnFirst = false;
	readonly #renderer: Renderer;
	/** Context of a canvas to which pictures of a shared renderer are copied. */
	readonly #copied: CanvasRenderingContext2D | undefined;
	readonly #stage = new Stage<S, G>(() => this.#loop.request());
	readonly #cameraController: CameraController;
	readonly #loop: FrameLoop;
	#profile: BoundingProfile | undefined;
	#held = false;
	/** Whether the plant is shown in the user's room instead. */
	#isInRoom = false;
	#rendered = 0;
	#size = { width: 1, height: 1 };

	/** @throws NoWebGL2Error where the browser has no WebGL 2 */
	constructor(canvas: HTMLCanvasElement, options: ViewerOptions = {}) {
		this.#canvas = canvas;
		this.#events = options.events ?? {};
		this.#renderer = options.renderer ?? new Renderer(canvas, options.checked ?? false);
		if (options.renderer) this.#copied = canvas.getContext("2d", { alpha: false }) ?? undefined;
		this.#loop = new FrameLoop((frame) => this.#frame(frame), window.devicePixelRatio, this.#renderer.slow);
		this.#cameraController = new CameraController(canvas, options.reducedMotion ?? false, () =>
			this.#loop.request(true),
		);
		if (options.still) this.#cameraController.controls.disconnect();
		this.setTheme(options.theme ?? "light");
		this.#renderer.canvas.addEventListener("webglcontextlost", this.#onLost);
		this.#renderer.canvas.addEventListener("webglcontextrestored", this.#onRestored);
		this.resize();
	}

	/** Sets the renderer of plants and removes the last one from the stage. */
	use(make: RendererFactory<S, G>): void {
		this.#stage.use(make);
		this.#profile = undefined;
		this.#cameraController.forget(this.#stage.elevation);
		this.camera.updateMatrixWorld();
		if (this.#canDraw) this.#submit(this.#stage.warmUp, this.#loop.rest);
		this.#loop.request();
	}

	/** Shows a plant in place of the last. Fast enough for every step of a drag: buffers and programs are reused. */
	show(grown: G, specimen: S): void {
		this.#profile = boundingProfileOf(this.#stage.show(grown, specimen));
		this.#setGround();
		this.#cameraController.follow(this.#profile, this.#held);
		this.#loop.request(true);
	}

	/** Modes of the renderer, the default first. */
	get modes(): readonly string[] {
		return this.#stage.modes;
	}

	/** Sets one of `modes`; other values are ignored. */
	setMode(mode: string): void {
		if (this.#stage.setMode(mode)) this.#loop.request();
	}

	/** Sets the light and the background of a colour scheme of the page. */
	setTheme(theme: Theme): void {
		this.#stage.setTheme(theme);
		this.#loop.request();
	}

	/**
	 * Sets whether plants that stand on the ground are shown outdoors, under the sky, instead of on paper; the first view
	 * is then from the height of a person's eyes.
	 */
	set outdoors(on: boolean) {
		const before = this.#stage.groundLevel;
		this.#stage.setOutdoors(on);
		this.#setGround();
		if (before !== this.#stage.groundLevel) this.#cameraController.fit();
		this.#loop.request();
	}

	/** Fits the drawing to the canvas's size on the page; call it after a change of size. */
	resize(): void {
		this.#loop.setDevice(window.devicePixelRatio);
		this.#setSize(this.#canvas.clientWidth || this.#canvas.width, this.#canvas.clientHeight || this.#canvas.height);
		this.#loop.request();
	}

	/**
	 * Sets whether a control is held: while it is, the view follows the plant only if the plant outgrows it; after
	 * release, it always follows.
	 */
	holdView(held: boolean): void {
		if (!held && this.#held && this.#profile) this.#cameraController.follow(this.#profile, false);
		this.#held = held;
	}

	/** Turns the plant, by radians to the right and down. */
	orbit(dx: number, dy: number): void {
		this.#cameraController.orbit(dx, dy);
	}

	/** Scales the plant's apparent size by `factor`. */
	zoom(factor: number): void {
		this.#cameraController.zoom(factor);
	}

	/** Shifts the plant by shares of the view's height, to the right and down. */
	pan(dx: number, dy: number): void {
		this.#cameraController.pan(dx, dy);
	}

	/** Shows the whole plant, from the default view or a named one. */
	resetView(view?: ViewName): void {
		this.#cameraController.fit(view);
	}

	/** The camera, whose position and lens overlays may read. */
	get camera(): PerspectiveCamera {
		return this.#cameraController.camera;
	}

	/** Disables gliding and damping. */
	set reducedMotion(on: boolean) {
		this.#cameraController.reducedMotion = on;
	}

	/** Sets whether a wind blows, which draws every frame. Pictures show the plant at rest. */
	set wind(on: boolean) {
		this.#stage.wind.blowing = on;
		this.#loop.request(true);
	}

	/** Sets whether pointers turn the plant; a handle in the scene switches this off during a drag. */
	set orbiting(enabled: boolean) {
		this.#cameraController.controls.enabled = enabled;
	}

	/** Whether the view follows a plant only to keep all of it in the picture, and never comes nearer. */
	set keepsWhole(on: boolean) {
		this.#cameraController.keepsWhole = on;
	}

	/**
	 * Adds an object to the scene, in the plant's metres.
	 * @param isPictured whether pictures show it; they leave out editing aids
	 */
	addOverlay(object: Object3D, isPictured = false): void {
		(isPictured ? this.#stage.scene : this.#stage.aids).add(object);
		this.#loop.request();
	}

	/** Removes an object that `addOverlay` added. */
	removeOverlay(object: Object3D): void {
		object.removeFromParent();
		this.#loop.request();
	}

	/** Sets whether editing aids are drawn. */
	set showsAids(on: boolean) {
		this.#stage.aids.visible = on;
		this.#loop.request();
	}

	/** Returns the position of a point of the plant on the canvas, in CSS pixels from its top left corner. */
	project({ x, y, z }: Pick<Vector3, "x" | "y" | "z">): { x: number; y: number } {
		this.camera.updateMatrixWorld();
		const at = new Vector3(x, y, z).project(this.camera);
		return { x: (0.5 + 0.5 * at.x) * this.#size.width, y: (0.5 - 0.5 * at.y) * this.#size.height };
	}

	/**
	 * Metres per CSS pixel at the depth of the plant's centre; undefined without a plant, and while the eye is among the
	 * plants.
	 */
	get pixelSize(): number | undefined {
		const span = this.#profile && this.#cameraController.spanAt(this.#profile.centre);
		return span && span / this.#size.height;
	}

	/**
	 * Returns the pick id at a point of the canvas (CSS pixels from its top left corner); undefined if there is
	 * nothing.
	 */
	pick(x: number, y: number): number | undefined {
		return this.#stage.pick(this.rayThrough(x, y));
	}

	/**
	 * Returns the visible point of the scene, metres, at a point of the canvas (CSS pixels from its top left corner), or
	 * nearest to it within a radius; undefined if nothing is there.
	 */
	async surfaceAt(x: number, y: number, reach: number): Promise<SceneVector | undefined> {
		const { surfacePoint } = await import("./surface_point");
		if (!this.#canDraw || !this.#stage.filled) return undefined;
		this.camera.updateMatrixWorld();
		const { scene } = this.#stage;
		return this.#renderer.use((three) => surfacePoint(three, scene, this.camera, this.#size, { x, y, reach }));
	}

	/** Marks the part with a pick id, and softly the ids of its group; undefined removes the mark. A new plant has no mark. */
	mark(picked: number | undefined, group?: ReadonlySet<number>): void {
		if (this.#stage.mark(picked, group)) this.#loop.request();
	}

	/** Places the eye at a position; undefined shows the whole plant again. */
	look(from: Gaze | undefined): void {
		this.#cameraController.look(from);
	}

	/** Requests a frame after changes of overlays. */
	requestRender(): void {
		this.#loop.request();
	}

	/** Number of pictures drawn so far, for tests and measurements. */
	get rendersCount(): number {
		return this.#rendered;
	}

	/** Resolves when nothing is left to draw and the GPU has finished. */
	async whenIdle(): Promise<void> {
		await this.#stage.whenFinished();
		await this.#loop.whenIdle();
		await this.#renderer.done();
	}

	/** Returns the current view as a PNG of the given size in pixels, without editing aids and marks. */
	async snapshot(width: number, height: number): Promise<Blob> {
		await this.#stage.whenFinished();
		const size = { width, height };
		if (this.#stage.samples > 1) {
			const { finePicture, samplesFor } = await import("./fine_picture");
			return this.#inSize(size, () => {
				this.#draw(samplesFor(size, this.#stage.samples));
				return finePicture(this.#canvas, size);
			});
		}
		return this.#inSize(size, () => {
			this.#draw(1);
			// toBlob copies the pixels before it returns, so that the view can be restored at once.
			return new Promise<Blob>((resolve, reject) => {
				this.#canvas.toBlob((blob) => {
					if (blob) resolve(blob);
					else reject(new Error(`The browser made no picture of ${width} × ${height} pixels; try a smaller one.`));
				});
			});
		});
	}

	/** Returns the plant as a PNG with a transparent background. */
	async cutOut(width: number, height: number): Promise<Blob> {
		const [{ cutOutOf }, { samplesFor }] = await Promise.all([import("./cut_out"), import("./fine_picture")]);
		await this.#stage.whenFinished();
		const size = { width, height };
		return this.#inSize(size, () =>
			cutOutOf(this.#canvas, size, (ground) => {
				this.#stage.setGround(ground);
				this.#draw(samplesFor(size, this.#stage.samples));
			}),
		);
	}

	/**
	 * Shows the plant in the user's room until a session of augmented reality ends; then the view is as before.
	 * @param placed called when the plant is placed for the first time
	 * @throws Error if the session cannot be drawn; it is then ended
	 */
	async showInRoom(session: XRSession, placed: () => void): Promise<void> {
		this.#isInRoom = true;
		const low = this.#profile ? lowestOf(this.#profile) : 0;
		try {
			const { showInRoom } = await import("./room_session");
			const draw = this.#stage.drawInRoom.bind(this.#stage);
			await this.#renderer.use((three) => showInRoom(session, three, { low, draw, placed }));
		} finally {
			this.#isInRoom = false;
			this.resize();
		}
	}

	/**
	 * Runs a callback while the view has another size and no wind blows, then restores the view.
	 * @throws Error if the graphics context is lost
	 */
	#inSize<Taken>({ width, height }: Size, take: () => Taken): Taken {
		if (this.#renderer.lost) throw new Error("The GPU has been lost; try again when the picture is back.");
		if (this.#isInRoom) throw new Error("The plant is being shown in your room; try again when that view is closed.");
		const { width: shownWidth, height: shownHeight } = this.#size;
		this.#setSize(width, height);
		try {
			return this.#stage.plantAlone(() => this.#stage.wind.calm(take));
		} finally {
			this.#setSize(shownWidth, shownHeight);
			this.#draw(this.#loop.rest);
		}
	}

	/** Releases the graphics context; a canvas with a renderer of its own cannot be drawn on again. */
	dispose(): void {
		this.#loop.stop();
		this.#renderer.canvas.removeEventListener("webglcontextlost", this.#onLost);
		this.#renderer.canvas.removeEventListener("webglcontextrestored", this.#onRestored);
		this.#cameraController.dispose();
		this.#stage.dispose();
		if (!this.#copied) this.#renderer.dispose();
	}

	/** Reports that the graphics context was lost; preventing the default lets the browser restore it. */
	readonly #onLost = (event: Event) => {
		event.preventDefault();
		this.#events.contextLost?.();
	};

	/** Draws everything again after the graphics context was restored, and reports that. */
	readonly #onRestored = () => {
		this.#stage.restored();
		this.#loop.request();
		this.#events.contextRestored?.();
	};

	/** Returns the ray through a point of the canvas, CSS pixels from its top left corner. */
	rayThrough(x: number, y: number): ViewRay {
		this.camera.updateMatrixWorld();
		const { width, height } = this.#size;
		const eye = this.camera.position;
		const through = new Vector3((2 * x) / width - 1, 1 - (2 * y) / height, 0).unproject(this.camera).sub(eye);
		return { origin: eye.toArray(), direction: through.toArray() };
	}

	/** Sets the size of the view in CSS pixels, at least 1 × 1. */
	#setSize(width: number, height: number): void {
		this.#size = { width: Math.max(1, width), height: Math.max(1, height) };
		this.#cameraController.setAspect(this.#size.width / this.#size.height);
	}

	/**
	 * Draws one frame of the loop, after advancing camera and wind.
	 * @returns whether a movement continues
	 */
	#frame({ ratio, now }: Frame): boolean {
		const moves = [this.#cameraController.advance(now), this.#stage.wind.blow(now)];
		this.#draw(ratio);
		return moves.includes(true);
	}

	/** Keeps the camera over the ground of the shown plant, if there is ground outdoors. */
	#setGround(): void {
		this.#cameraController.setGround(this.#stage.groundLevel, this.#stage.outdoorElevation);
	}

	/** Whether the canvas can be drawn on now. */
	get #canDraw(): boolean {
		return !this.#renderer.lost && !this.#isInRoom;
	}

	/**
	 * Draws the stage and reports it to the viewer's events.
	 * @param ratio pixels per CSS pixel
	 */
	#draw(ratio: number): void {
		if (!this.#canDraw) return;
		this.camera.updateMatrixWorld();
		this.#submit(this.#stage, ratio);
		this.#rendered++;
		this.#events.drawn?.();
		if (this.#stage.filled && !this.#drawnFirst) this.#events.firstDraw?.();
		this.#drawnFirst ||= this.#stage.filled;
	}

	/**
	 * Draws a stage in the view's size and copies the picture, if the renderer is shared.
	 * @param ratio pixels per CSS pixel
	 */
	#submit(stage: Drawable, ratio: number): void {
		const { width, height } = this.#size;
		const size: Size = { width: Math.ceil(width * ratio), height: Math.ceil(height * ratio) };
		this.#renderer.draw(stage, this.camera, this.#cameraController.paper, size);
		if (this.#copied) this.#renderer.copy(this.#copied, size);
	}
}
