/** The picture of an element's plant: a viewer on the page's one context of the graphics card, turned by hand, by keys or by itself. */
import type { PageModel } from "../models/page_model";
import { loadRenderer, loadScene } from "../models/renderers";
import type { Plant } from "../plant/plant";
import type { Ray } from "../render/model_renderer";
import { turnedBy } from "../render/orbit_keys";
import type { Viewer } from "../render/viewer";
import type { Specimen } from "../specimen/specimen";
import type { Commons } from "./commons";

/** Degrees a second, where `autorotate` says no number. */
const TURNING = 20;

export class SpecimenView {
	readonly #canvas: HTMLCanvasElement;
	readonly #viewer: Viewer<Specimen, Plant>;
	readonly #ended = new AbortController();
	#rendererModel: PageModel | undefined;
	#seen = false;
	/** Degrees a second; 0 stands still. */
	#turning = 0;
	#frame = 0;
	#grasped = false;
	#windy = false;
	#paused = false;
	readonly #reduced: MediaQueryList;
	/** What lies over the picture, and is told when that has been drawn. */
	readonly #drawListeners: Set<() => void>;

	private constructor(
		canvas: HTMLCanvasElement,
		viewer: Viewer<Specimen, Plant>,
		reduced: MediaQueryList,
		drawListeners: Set<() => void>,
	) {
		this.#drawListeners = drawListeners;
		this.#canvas = canvas;
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
		// A page scrolls past: only a plant that has been chosen takes the wheel.
		canvas.addEventListener("wheel", (event) => this.#passWheel(event), { signal, capture: true });
		reduced.addEventListener("change", () => this.#followMotion(), { signal });
	}

	/** @throws NoWebGL2Error where the browser has none, and what the loading of scripts throws */
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
		// The turntable keeps all touches to itself; here those that go up and down are the page's.
		canvas.style.touchAction = "pan-y";
		return new SpecimenView(canvas, viewer, reduced, drawListeners);
	}

	/** Shows a plant in place of the last. */
	async show(model: PageModel, grown: Plant, specimen: Specimen): Promise<void> {
		if (model !== this.#rendererModel) {
			const createRenderer = await loadRenderer(model);
			if (this.#ended.signal.aborted) return;
			this.#viewer.use(createRenderer);
			this.#rendererModel = model;
		}
		this.#viewer.show(grown, specimen);
	}

	setDark(dark: boolean): void {
		this.#viewer.setTheme(dark ? "dark" : "light");
	}

	/** Whether any of it is on screen: what is not turns no further. */
	setSeen(seen: boolean): void {
		this.#seen = seen;
		this.#turn();
		this.#blow();
	}

	/** @param said the attribute: null for a plant that stands, a number of degrees a second, or anything else for a slow one */
	setTurning(attribute: string | null): void {
		const speed = Number(attribute || TURNING);
		this.#turning = attribute === null ? 0 : Number.isFinite(speed) ? speed : TURNING;
		this.#turn();
	}

	/** @param said the attribute: null where it is calm */
	setWind(attribute: string | null): void {
		this.#windy = attribute !== null;
		this.#blow();
	}

	/** Whether its reader has the wind wait. */
	setPaused(paused: boolean): void {
		this.#paused = paused;
		this.#blow();
	}

	/** Whether it may turn by itself: less motion is wished for where not. */
	get turnsByItself(): boolean {
		return !this.#reduced.matches;
	}

	/** Turns the plant by degrees, once. */
	turnBy(degrees: number): void {
		this.#viewer.orbit((degrees * Math.PI) / 180, 0);
	}

	/** While a hand changes the plant, the view goes after it only where it outgrows that. */
	hold(held: boolean): void {
		this.#viewer.holdView(held);
	}

	/** Where a point of the plant, in metres, is on the canvas: CSS pixels from its top left corner. */
	project([x, y, z]: readonly [number, number, number]): { x: number; y: number } {
		return this.#viewer.project({ x, y, z });
	}

	/** The line of sight through a point of the canvas. */
	rayThrough(x: number, y: number): Ray {
		return this.#viewer.rayThrough(x, y);
	}

	/** Calls back after every draw. @returns what ends it */
	onDrawn(listener: () => void): () => void {
		this.#drawListeners.add(listener);
		return () => this.#drawListeners.delete(listener);
	}

	reset(): void {
		this.#viewer.resetView();
	}

	resize(): void {
		this.#viewer.resize();
	}

	/** The present view as a PNG of so many pixels. */
	picture(width: number, height: number): Promise<Blob> {
		return this.#viewer.snapshot(width, height);
	}

	/** Settles when nothing is left to draw. */
	whenIdle(): Promise<void> {
		return this.#viewer.whenIdle();
	}

	dispose(): void {
		this.#ended.abort();
		cancelAnimationFrame(this.#frame);
		this.#viewer.dispose();
	}

	#followMotion(): void {
		this.#viewer.reducedMotion = this.#reduced.matches;
		this.#turn();
		this.#blow();
	}

	#grasp(grasped: boolean): void {
		this.#grasped = grasped;
		this.#turn();
	}

	#passWheel(event: WheelEvent): void {
		const { activeElement } = this.#canvas.getRootNode() as ShadowRoot;
		if (activeElement !== this.#canvas) event.stopPropagation();
	}

	/** Only where it is seen, and nobody wishes for less motion or has paused it. */
	#blow(): void {
		this.#viewer.wind = this.#windy && !this.#paused && this.#seen && !this.#reduced.matches;
	}

	/** Begins or ends turning by itself. */
	#turn(): void {
		const turns = this.#turning !== 0 && this.#seen && !this.#grasped && !this.#reduced.matches;
		cancelAnimationFrame(this.#frame);
		this.#frame = 0;
		if (!turns) return;
		let last: number | undefined;
		const step = (now: number) => {
			// A page that was hidden goes on where it was.
			const seconds = Math.min((now - (last ?? now)) / 1000, 0.1);
			last = now;
			this.#viewer.orbit((this.#turning * seconds * Math.PI) / 180, 0);
			this.#frame = requestAnimationFrame(step);
		};
		this.#frame = requestAnimationFrame(step);
	}
}
