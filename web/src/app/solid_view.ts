/** The 3-D view of the studio's state; the studio's only access to the scene. */
import type { Camera, Object3D } from "three";
import type { PageModel } from "../models/page_model";
import { loadRenderer, loadScene } from "../models/renderers";
import type { Plant } from "../plant/plant";
import { turnedBy } from "../render/orbit_keys";
import type { Viewer } from "../render/viewer";
import type { Specimen } from "../specimen/specimen";
import type { PointerRay } from "../ui/handles/handle_ways";
import type { ModelUi, SubstitutePlant, ToolInteraction, ToolView } from "../ui/tool";
import { text } from "./messages.generated";
import type { Studio } from "./studio";
import { lookOf, type PictureOptions, type ShownPlant, type StudioState } from "./studio_state";

/** Events of the canvas. */
export interface SolidViewEvents {
	lost(): void;
	restored(): void;
	/** The user's preference for reduced motion has changed. */
	motion(): void;
}

/**
 * Name of the performance measure of building the scene of a plant: only the last entry is retained (`npm run bench`).
 */
const SHOW_MEASURE = "shown";
/** Pixels of a picture per CSS pixel. */
const PICTURE_SCALE = 2;

export class SolidView implements ToolView {
	readonly canvas: HTMLCanvasElement;
	readonly #view: Viewer<Specimen, Plant>;
	readonly #studio: Studio;
	readonly #reduced = matchMedia("(prefers-reduced-motion: reduce)");
	#wind = false;
	/** Whether tools find the part under a pointer; false while clicks have another meaning. */
	picksParts = true;
	/** Called after every draw. */
	readonly #drawListeners: Set<() => void>;
	#orbiting = true;
	#disposed = false;
	readonly #lifetime = new AbortController();
	/** The model whose renderer is in use, and the model whose renderer is being loaded. */
	#rendererModel: PageModel | undefined;
	#loadingModel: PageModel | undefined;
	/** The model whose script could not be fetched: it is fetched again on request, or after another model was shown. */
	#failedModel: PageModel | undefined;
	#shown: ShownPlant | undefined;
	#outdoors: boolean | undefined;
	#look: StudioState["specimen"]["look"] | undefined;
	/** The plant that a tool shows in place of the document's, and the plant in view. */
	#instead: SubstitutePlant | undefined;
	#viewedPlant: Plant | undefined;
	/** Number of pictures being taken. */
	#picturesInProgress = 0;
	#dark: boolean | undefined;
	/** Interactions of the tools of `#modelUi`. */
	#interactions: ToolInteraction[] = [];
	#modelUi: ModelUi | undefined;

	/** @param drawListeners called after each drawn frame */
	private constructor(
		canvas: HTMLCanvasElement,
		view: Viewer<Specimen, Plant>,
		studio: Studio,
		drawListeners: Set<() => void>,
	) {
		this.#drawListeners = drawListeners;
		this.canvas = canvas;
		this.#view = view;
		this.#studio = studio;
	}

	/**
	 * Loads the scripts of the 3-D view and of the model's renderer, and creates the view on a canvas.
	 * @throws NoWebGL2Error where the browser has no WebGL 2, and errors of loading the scripts
	 */
	static async create(canvas: HTMLCanvasElement, studio: Studio, events: SolidViewEvents): Promise<SolidView> {
		const { model, dark } = studio.state;
		// Load both scripts first: a canvas gives one context, so nothing may fail after it is created.
		const [{ Viewer }] = await Promise.all([loadScene(), loadRenderer(model)]);
		const theme = dark ? "dark" : "light";
		const drawListeners = new Set<() => void>();
		const view = new Viewer<Specimen, Plant>(canvas, {
			reducedMotion: matchMedia("(prefers-reduced-motion: reduce)").matches,
			theme,
			checked: import.meta.env.DEV,
			events: {
				drawn: () => {
					for (const listener of drawListeners) listener();
				},
				firstDraw: () => performance.mark("first-bunch"),
				contextLost: () => events.lost(),
				contextRestored: () => events.restored(),
			},
		});
		const solid = new SolidView(canvas, view, studio, drawListeners);
		solid.#followMotion(() => events.motion());
		await solid.#useRenderer(model);
		return solid;
	}

	/** Updates the view to the state; unchanged parts cost nothing. */
	update(state: StudioState): void {
		const { shown, model, held, dark, modelUi, ui } = state;
		if (shown && shown.model !== this.#rendererModel) {
			if (shown.model !== this.#failedModel) void this.#loadRenderer(shown.model);
			return;
		}
		this.#failedModel = undefined;
		const instead = this.#picturesInProgress > 0 ? undefined : this.#instead;
		// A substitute plant is shown from the same camera position, for comparison.
		this.#view.holdView(held || instead !== undefined);
		const look = shown && lookOf(shown, state);
		if (ui.outdoors !== this.#outdoors) this.#view.outdoors = ui.outdoors;
		this.#outdoors = ui.outdoors;
		const { grown, from } = instead ?? shown ?? {};
		if (grown && from && look && (grown !== this.#viewedPlant || shown !== this.#shown || look !== this.#look)) {
			const start = performance.now();
			this.#view.show(grown, { ...from, look });
			performance.clearMeasures(SHOW_MEASURE);
			performance.measure(SHOW_MEASURE, { start });
		}
		this.#shown = shown;
		this.#look = look;
		this.#viewedPlant = grown;
		if (dark !== this.#dark) this.#view.setTheme(dark ? "dark" : "light");
		this.#dark = dark;
		// The plant in view may still belong to another model.
		this.#setModelUi(shown && shown.model !== model ? undefined : modelUi);
		for (const interaction of this.#interactions) interaction.update(state);
	}

	/** Returns the current view of the document's plant, as a PNG. */
	async picture(options: PictureOptions = {}): Promise<Blob> {
		this.#picturesInProgress++;
		this.update(this.#studio.state);
		try {
			return await this.#capture(options);
		} finally {
			this.#picturesInProgress--;
			if (this.#instead) this.update(this.#studio.state);
		}
	}

	/** Takes a picture at the given height in pixels, with or without background. */
	#capture({ height, alone }: PictureOptions): Promise<Blob> {
		const { clientWidth, clientHeight } = this.canvas;
		const scale = height === undefined ? PICTURE_SCALE : height / clientHeight;
		const [width, tall] = [Math.round(clientWidth * scale), Math.round(clientHeight * scale)];
		return alone ? this.#view.cutOut(width, tall) : this.#view.snapshot(width, tall);
	}

	/** Turns, moves and zooms by keys. @returns whether the key does so */
	press(event: KeyboardEvent): boolean {
		return turnedBy(this.#view, event);
	}

	/** Turns the plant to the left by an angle, radians. */
	turn(angle: number): void {
		this.#view.orbit(-angle, 0);
	}

	/** Sets whether tools' editing aids in the scene are shown, such as outlines. */
	set showsAids(on: boolean) {
		this.#view.showsAids = on;
	}

	/** Shows the plant in the user's room until a session of augmented reality ends. */
	showInRoom(session: XRSession, placed: () => void): Promise<void> {
		return this.#view.showInRoom(session, placed);
	}

	/** Resets the camera to show the whole plant. */
	reset(): void {
		this.#view.resetView();
	}

	/** Whether animation is allowed: false where the user prefers reduced motion. */
	get movesByItself(): boolean {
		return !this.#reduced.matches;
	}

	/** Whether the wind animation is on. */
	get wind(): boolean {
		return this.#wind;
	}

	set wind(on: boolean) {
		this.#wind = on && this.movesByItself;
		this.#view.wind = this.#wind;
	}

	/** Adapts to a new size of the canvas. */
	resize(): void {
		this.#view.resize();
	}

	/** Ends the view and releases its graphics memory. */
	dispose(): void {
		this.#disposed = true;
		this.#lifetime.abort();
		this.#setModelUi(undefined);
		this.#view.dispose();
	}

	/** Metres per CSS pixel at the depth of the plant's centre; undefined without a plant in front of the eye. */
	get pixelSize(): number | undefined {
		return this.#view.pixelSize;
	}

	/** The camera of the view. */
	get camera(): Camera {
		return this.#view.camera;
	}

	/** Whether drags turn the view. */
	get orbiting(): boolean {
		return this.#orbiting;
	}

	set orbiting(on: boolean) {
		this.#orbiting = on;
		this.#view.orbiting = on;
	}

	/** Sets whether the camera follows so that the whole plant stays in view. */
	keepWhole(on: boolean): void {
		this.#view.keepsWhole = on;
	}

	/**
	 * Adds an object over the plant.
	 * @param isPictured whether pictures show it
	 */
	addOverlay(object: Object3D, isPictured = false): void {
		this.#view.addOverlay(object, isPictured);
	}

	/** Removes an object that was added over the plant. */
	removeOverlay(object: Object3D): void {
		this.#view.removeOverlay(object);
	}

	/** Draws a frame soon. */
	requestRender(): void {
		this.#view.requestRender();
	}

	/**
	 * Returns the number of the part of the plant at a position of the canvas, CSS pixels; undefined where there is none.
	 */
	pick(x: number, y: number): number | undefined {
		return this.picksParts ? this.#view.pick(x, y) : undefined;
	}

	/** Returns the visible point of the scene at a point of the canvas, or within `reach` CSS pixels of it; metres. */
	surfaceAt(x: number, y: number, reach: number): Promise<PointerRay["origin"] | undefined> {
		return this.#view.surfaceAt(x, y, reach);
	}

	/** Highlights a part that `pick` returned, and softly the pick ids of its group; undefined ends the highlight. */
	mark(picked: number | undefined, group?: ReadonlySet<number>): void {
		this.#view.mark(picked, group);
	}

	/** Returns the ray from the eye through a position of the canvas, CSS pixels. */
	rayThrough(x: number, y: number): PointerRay {
		return this.#view.rayThrough(x, y);
	}

	/** Returns the position on the canvas, CSS pixels, of a point in metres. */
	project([x, y, z]: PointerRay["origin"]): { x: number; y: number } {
		return this.#view.project({ x, y, z });
	}

	/** Sets the eye and the point that it looks at; undefined returns to the view from before. */
	look(from: Parameters<ToolView["look"]>[0]): void {
		this.#view.look(from);
	}

	/** Calls back after every drawn frame; returns a function that ends it. */
	onDrawn(listener: () => void): () => void {
		this.#drawListeners.add(listener);
		return () => this.#drawListeners.delete(listener);
	}

	/** Shows another plant in place of the document's; undefined shows the document's again. */
	showSubstitute(plant: SubstitutePlant | undefined): void {
		if (plant?.grown === this.#instead?.grown) return;
		this.#instead = plant;
		this.update(this.#studio.state);
	}

	/** Sets the mode of display; undefined sets the renderer's first one. */
	setMode(mode: string | undefined): void {
		this.#view.setMode(mode ?? this.#view.modes[0]);
	}

	/** Follows changes of the user's preference for reduced motion. */
	#followMotion(changed: () => void): void {
		const follow = ({ matches }: MediaQueryListEvent) => {
			this.#view.reducedMotion = matches;
			this.wind = false;
			changed();
		};
		this.#reduced.addEventListener("change", follow, { signal: this.#lifetime.signal });
	}

	/** Replaces the renderer by that of a model. */
	async #useRenderer(model: PageModel): Promise<void> {
		const createRenderer = await loadRenderer(model);
		if (this.#disposed) return;
		this.#view.use(createRenderer);
		this.#rendererModel = model;
		this.#shown = undefined;
	}

	/** Loads and uses the renderer of a model; the newest call wins. */
	async #loadRenderer(model: PageModel): Promise<void> {
		if (model === this.#loadingModel) return;
		this.#loadingModel = model;
		this.#failedModel = undefined;
		const isWanted = () => model === this.#loadingModel && !this.#disposed;
		try {
			await loadRenderer(model);
			if (isWanted()) await this.#useRenderer(model);
		} catch {
			if (isWanted()) this.#reportMissing(model);
			return;
		}
		if (!isWanted()) return;
		this.#loadingModel = undefined;
		this.update(this.#studio.state);
	}

	/**
	 * Reports that a model cannot be drawn. The notice updates the view, so fetching again at each update would never
	 * end.
	 */
	#reportMissing(model: PageModel): void {
		this.#loadingModel = undefined;
		this.#failedModel = model;
		const again = () => void this.#loadRenderer(model);
		const details = [text("still_usable"), text("fetch_failed_advice")];
		this.#studio.notify(text("stage_not_drawn"), details, { again });
	}

	/** Replaces the tools' interactions with the canvas by those of a model. */
	#setModelUi(modelUi: ModelUi | undefined): void {
		if (modelUi === this.#modelUi) return;
		this.#instead = undefined;
		for (const interaction of this.#interactions) interaction.dispose();
		this.#modelUi = modelUi;
		this.#interactions = modelUi?.tools.flatMap((tool) => tool.interaction?.(this, this.#studio) ?? []) ?? [];
	}
}
