/**
 * The picture of an element's plant: a viewer on the page's shared WebGL context, turned by pointer, by keys or by
 * itself.
 */
import type { PageModel } from "../models/page_model";
import { loadRenderer, loadScene } from "../models/renderers";
import type { Plant } from "../plant/plant";
import type { ViewRay } from "../render/model_renderer";
import { turnedBy } from "../render/orbit_keys";
import type { Viewer } from "../render/viewer";
import type { Specimen } from "../specimen/specimen";
import type { Commons } from "./commons";
import { leaveScrollingToPage } from "./page_scrolling";

/** Default of `autorotate`, degrees per second. */
const TURNING = 20;

export class SpecimenView {
	readonly #viewer: Viewer<Specimen, Plant>;
	readonly #ended = new AbortController();
	#rendererModel: PageModel | undefined;
	#seen = false;
	/** Degrees per second; 0: the plant does not turn by itself. */
	#turning = 0;
	#frame = 0;
	#grasped = false;
	#windy = false;
	#paused = false;
	readonly #reduced: MediaQueryList;
	/** Called after every draw, by layers over the picture. */
	readonly #drawListeners: Set<() => void>;

	/**
	 * Listens to the canvas until the view is disposed of.
	 * @param reduced whether the user prefers reduced motion
	 * @param drawListeners called after each drawn frame
	 */
	private constructor(
		canvas: HTMLCanvasElement,
		viewer: Viewer<Specimen, Plant>,
		reduced: MediaQueryList,
		drawListeners: Set<() => void>,
	) {
		this.#drawListeners = drawListeners;
		this.#viewer = viewer;
		this.#reduced = reduced;
		const { signal } = this.#ended;
		const listen = (type: string, listener: (event: Event) => void) =>
			canvas.addEventListener(type, listener, { signal });
		listen("keydown", (event) => {
			if (turnedBy(viewer, event as KeyboardEvent)) event.preventDefault();
		});
		listen("pointerdown", () => this.#grasp(true));
		for (const end of ["pointerup", "pointercancel"]) listen(end, () => this.#grasp(false));
		leaveScrollingToPage(canvas, signal);
		reduced.addEventListener("change", () => this.#followMotion(), { signal });
	}

	/**
	 * Loads the scripts and creates the view on a canvas.
	 * @throws NoWebGL2Error if the browser has no WebGL 2, and errors of loading scripts
	 */
	static async create(canvas: HTMLCanvasElement, commons: Commons, events: { drawn(): void }): Promise<SpecimenView> {
		const [{ Viewer }, renderer] = await Promise.all([loadScene(), commons.renderer()]);
		const reduced = matchMedia("(prefers-reduced-motion: reduce)");
		const drawListeners = new Set<() => void>();
		const drawn = () => {
			for (const listener of drawListeners) listener();
		};
		const viewer = new Viewer<Specimen, Plant>(canvas, {
			renderer,
			reducedMotion: reduced.matches,
			events: { firstDraw: () => events.drawn(), drawn },
		});
		// The camera controller would take all touches; the element's style sheet leaves the vertical ones to the page.
		canvas.style.touchAction = "";
		return new SpecimenView(canvas, viewer, reduced, drawListeners);
	}

	/** Shows a plant instead of the last one. */
	async show(model: PageModel, grown: Plant, specimen: Specimen): Promise<void> {
		if (model !== this.#rendererModel) {
			const createRenderer = await loadRenderer(model);
			if (this.#ended.signal.aborted) return;
			this.#viewer.use(createRenderer);
			this.#rendererModel = model;
		}
		this.#viewer.show(grown, specimen);
	}

	/** Sets the light and the background of the dark or the light scheme. */
	setDark(dark: boolean): void {
		this.#viewer.setTheme(dark ? "dark" : "light");
	}

	/** Sets whether the element is in the viewport; animation stops outside. */
	setSeen(seen: boolean): void {
		this.#seen = seen;
		this.#turn();
		this.#blow();
	}

	/**
	 * Sets the speed of turning. @param attribute null: no turning; a number: degrees per second; any other text: the
	 * default speed
	 */
	setTurning(attribute: string | null): void {
		const speed = Number(attribute || TURNING);
		this.#turning = attribute === null ? 0 : Number.isFinite(speed) ? speed : TURNING;
		this.#turn();
	}

	/** Switches the wind. @param attribute null: off */
	setWind(attribute: string | null): void {
		this.#windy = attribute !== null;
		this.#blow();
	}

	/** Sets whether plants that stand on the ground are shown outdoors. */
	setOutdoors(on: boolean): void {
		this.#viewer.outdoors = on;
	}

	/** Pauses the wind, or lets it go on. */
	setPaused(paused: boolean): void {
		this.#paused = paused;
		this.#blow();
	}

	/** Whether the plant may turn by itself: false where the user prefers reduced motion. */
	get turnsByItself(): boolean {
		return !this.#reduced.matches;
	}

	/** Turns the plant by an angle, once. */
	turnBy(degrees: number): void {
		this.#viewer.orbit((degrees * Math.PI) / 180, 0);
	}

	/** Sets whether a control is dragged: the camera then follows the plant only if it outgrows the picture. */
	hold(held: boolean): void {
		this.#viewer.holdView(held);
	}

	/** Projects a point of the plant (metres) to the canvas: CSS pixels from its top left corner. */
	project([x, y, z]: readonly [number, number, number]): { x: number; y: number } {
		return this.#viewer.project({ x, y, z });
	}

	/** The line of sight through a point of the canvas (CSS pixels), in metres. */
	rayThrough(x: number, y: number): ViewRay {
		return this.#viewer.rayThrough(x, y);
	}

	/** Calls back after every draw. @returns a function that ends it */
	onDrawn(listener: () => void): () => void {
		this.#drawListeners.add(listener);
		return () => this.#drawListeners.delete(listener);
	}

	/** Shows the whole plant, from the initial direction. */
	reset(): void {
		this.#viewer.resetView();
	}

	/** Fits the drawing to the canvas's size on the page. */
	resize(): void {
		this.#viewer.resize();
	}

	/** The current view as a PNG of the given size in pixels. */
	picture(width: number, height: number): Promise<Blob> {
		return this.#viewer.snapshot(width, height);
	}

	/** Resolves when nothing is left to draw. */
	whenIdle(): Promise<void> {
		return this.#viewer.whenIdle();
	}

	/** Ends animation and frees the view; the shared context stays. */
	dispose(): void {
		this.#ended.abort();
		cancelAnimationFrame(this.#frame);
		this.#viewer.dispose();
	}

	/** Follows a change of the user's preference for reduced motion. */
	#followMotion(): void {
		this.#viewer.reducedMotion = this.#reduced.matches;
		this.#turn();
		this.#blow();
	}

	/** Stops turning while a pointer turns the plant. */
	#grasp(grasped: boolean): void {
		this.#grasped = grasped;
		this.#turn();
	}

	/** Runs the wind if it is on, in the viewport, not paused, and the user does not prefer reduced motion. */
	#blow(): void {
		this.#viewer.wind = this.#windy && !this.#paused && this.#seen && !this.#reduced.matches;
	}

	/** Starts or stops turning by itself. */
	#turn(): void {
		const turns = this.#turning !== 0 && this.#seen && !this.#grasped && !this.#reduced.matches;
		cancelAnimationFrame(this.#frame);
		this.#frame = 0;
		if (!turns) return;
		let last: number | undefined;
		const step = (now: number) => {
			// After the page was hidden, continue from the same angle.
			const seconds = Math.min((now - (last ?? now)) / 1000, 0.1);
			last = now;
			this.#viewer.orbit((this.#turning * seconds * Math.PI) / 180, 0);
			this.#frame = requestAnimationFrame(step);
		};
		this.#frame = requestAnimationFrame(step);
	}
}
