/** The 3-D view as the studio's state wants it; the one place where the studio meets the scene. */
import type { Camera, Object3D } from "three";
import type { PageModel } from "../models/page_model";
import { loadRenderer, loadScene } from "../models/renderers";
import type { Plant } from "../plant/plant";
import { turnedBy } from "../render/orbit_keys";
import type { Viewer } from "../render/viewer";
import type { Specimen } from "../specimen/specimen";
import type { Ray } from "../ui/handles/handle_ways";
import type { ModelUi, SubstitutePlant, ToolInteraction, ToolView } from "../ui/tool";
import type { Studio } from "./studio";
import { lookOf, type PictureOptions, type ShownPlant, type StudioState } from "./studio_state";
import { TRY_AGAIN } from "./types";

/** What the canvas has to tell besides the plant. */
export interface SolidViewEvents {
	lost(): void;
	restored(): void;
	/** Less motion is wished for from now on, or no more. */
	motion(): void;
}

/** The measure of laying a plant on the stage, up to where three.js has it: the last one stands (`npm run bench`). */
const SHOW_MEASURE = "laid";
/** Pixels of a picture to one of the page. */
const PICTURE_SCALE = 2;

export class SolidView implements ToolView {
	readonly canvas: HTMLCanvasElement;
	readonly #view: Viewer<Specimen, Plant>;
	readonly #studio: Studio;
	readonly #reduced = matchMedia("(prefers-reduced-motion: reduce)");
	#wind = false;
	/** Who is told when the picture has been drawn. */
	readonly #drawListeners: Set<() => void>;
	#orbiting = true;
	#disposed = false;
	readonly #lifetime = new AbortController();
	/** Whose figure is on the stage, and whose is on its way. */
	#rendererModel: PageModel | undefined;
	#loadingModel: PageModel | undefined;
	/** The model whose script could not be fetched: it is fetched again on request, or after another model was shown. */
	#failedModel: PageModel | undefined;
	#shown: ShownPlant | undefined;
	#look: StudioState["specimen"]["look"] | undefined;
	/** What a tool shows, and what is shown of that. */
	#instead: SubstitutePlant | undefined;
	#viewedPlant: Plant | undefined;
	/** How many pictures are being taken. */
	#picturesInProgress = 0;
	#dark: boolean | undefined;
	/** The hands of the tools of `#face`. */
	#interactions: ToolInteraction[] = [];
	#modelUi: ModelUi | undefined;

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

	/** @throws NoWebGL2Error where the browser has none, and whatever the loading of the script throws */
	static async create(canvas: HTMLCanvasElement, studio: Studio, events: SolidViewEvents): Promise<SolidView> {
		const { model, dark } = studio.state;
		// Both first: a canvas gives one context, so that nothing may fail once it is taken.
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

	/** Brings the view to the state; what has not changed costs nothing. */
	update(state: StudioState): void {
		const { shown, model, held, dark, modelUi } = state;
		if (shown && shown.model !== this.#rendererModel) {
			if (shown.model !== this.#failedModel) void this.#loadRenderer(shown.model);
			return;
		}
		this.#failedModel = undefined;
		const instead = this.#picturesInProgress > 0 ? undefined : this.#instead;
		// What is compared with the plant is to be seen from where that is.
		this.#view.holdView(held || instead !== undefined);
		const look = shown && lookOf(shown, state);
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
		// What is in view may still be another model's.
		this.#setModelUi(shown && shown.model !== model ? undefined : modelUi);
		for (const interaction of this.#interactions) interaction.update(state);
	}

	/** The present view as a PNG, of the document's plant. */
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

	#capture({ height, alone }: PictureOptions): Promise<Blob> {
		const { clientWidth, clientHeight } = this.canvas;
		const scale = height === undefined ? PICTURE_SCALE : height / clientHeight;
		const [width, tall] = [Math.round(clientWidth * scale), Math.round(clientHeight * scale)];
		return alone ? this.#view.cutOut(width, tall) : this.#view.snapshot(width, tall);
	}

	/** Turns, moves and zooms by keys; tells whether the key was one of them. */
	press(event: KeyboardEvent): boolean {
		return turnedBy(this.#view, event);
	}

	/** The whole plant again, as the page opens with it. */
	reset(): void {
		this.#view.resetView();
	}

	/** Whether anything may move by itself: less motion is wished for where not. */
	get movesByItself(): boolean {
		return !this.#reduced.matches;
	}

	/** Whether a wind blows on the plant. */
	get wind(): boolean {
		return this.#wind;
	}

	set wind(on: boolean) {
		this.#wind = on && this.movesByItself;
		this.#view.wind = this.#wind;
	}

	/** The canvas has another size. */
	resize(): void {
		this.#view.resize();
	}

	dispose(): void {
		this.#disposed = true;
		this.#lifetime.abort();
		this.#setModelUi(undefined);
		this.#view.dispose();
	}

	get camera(): Camera {
		return this.#view.camera;
	}

	get orbiting(): boolean {
		return this.#orbiting;
	}

	set orbiting(on: boolean) {
		this.#orbiting = on;
		this.#view.orbiting = on;
	}

	keepWhole(on: boolean): void {
		this.#view.keepsWhole = on;
	}

	addOverlay(object: Object3D): void {
		this.#view.addOverlay(object);
	}

	removeOverlay(object: Object3D): void {
		this.#view.removeOverlay(object);
	}

	requestRender(): void {
		this.#view.requestRender();
	}

	pick(x: number, y: number): number | undefined {
		return this.#view.pick(x, y);
	}

	mark(picked: number | undefined, whole?: ReadonlySet<number>): void {
		this.#view.mark(picked, whole);
	}

	rayThrough(x: number, y: number): Ray {
		return this.#view.rayThrough(x, y);
	}

	project([x, y, z]: Ray["origin"]): { x: number; y: number } {
		return this.#view.project({ x, y, z });
	}

	look(from: Parameters<ToolView["look"]>[0]): void {
		this.#view.look(from);
	}

	onDrawn(listener: () => void): () => void {
		this.#drawListeners.add(listener);
		return () => this.#drawListeners.delete(listener);
	}

	showSubstitute(plant: SubstitutePlant | undefined): void {
		if (plant?.grown === this.#instead?.grown) return;
		this.#instead = plant;
		this.update(this.#studio.state);
	}

	setMode(mode: string | undefined): void {
		this.#view.setMode(mode ?? this.#view.modes[0]);
	}

	/** Motion may become unwelcome, or welcome, while the page stands. */
	#followMotion(tell: () => void): void {
		const follow = ({ matches }: MediaQueryListEvent) => {
			this.#view.reducedMotion = matches;
			this.wind = false;
			tell();
		};
		this.#reduced.addEventListener("change", follow, { signal: this.#lifetime.signal });
	}

	/** Puts a model's figure on the stage, in place of the last one's. */
	async #useRenderer(model: PageModel): Promise<void> {
		const figure = await loadRenderer(model);
		if (this.#disposed) return;
		this.#view.use(figure);
		this.#rendererModel = model;
		this.#shown = undefined;
	}

	/** The same while the page goes on; the newest that was asked for is the one that comes. */
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

	/** Reports that a model cannot be drawn. The notice updates the view, so fetching again at each update would never end. */
	#reportMissing(model: PageModel): void {
		this.#loadingModel = undefined;
		this.#failedModel = model;
		const again = () => void this.#loadRenderer(model);
		const details = ["Part of the page could not be fetched; sliders and downloads work all the same.", TRY_AGAIN];
		this.#studio.notify(`The ${model.noun} cannot be drawn`, details, { again });
	}

	/** Gives the canvas into the hands of a model's tools. */
	#setModelUi(modelUi: ModelUi | undefined): void {
		if (modelUi === this.#modelUi) return;
		this.#instead = undefined;
		for (const interaction of this.#interactions) interaction.dispose();
		this.#modelUi = modelUi;
		this.#interactions = modelUi?.tools.flatMap((tool) => tool.interaction?.(this, this.#studio) ?? []) ?? [];
	}
}
