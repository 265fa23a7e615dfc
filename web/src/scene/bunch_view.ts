import {
	NeutralToneMapping,
	type Object3D,
	type PerspectiveCamera,
	SRGBColorSpace,
	Vector3,
	WebGLRenderer,
} from "three";
import type { Grown } from "../models/bunch/grown";
import type { Look } from "../specimen/specimen";
import { type Spindle, spindleOf } from "./camera_fit";
import { FrameLoop } from "./frame_loop";
import type { Theme } from "./light";
import { NoWebGL2Error } from "./no_webgl2";
import { pickBerry } from "./picking";
import { type Mode, Stage } from "./stage";
import { Turntable, type ViewName } from "./turntable";

/** Of so many points of the foliage, one counts for the fit. */
const LEAF_POINTS = 8;

export interface BunchViewOptions {
	/** No gliding, no damping. */
	reducedMotion?: boolean;
	theme?: Theme;
	/** Takes no pointer: for pictures. */
	still?: boolean;
}

/** A bunch, lit, on a canvas. Draws only when something has changed. */
export class BunchView {
	/** Called once, when the first draw with a bunch has been submitted. */
	onFirstDraw?: () => void;
	/** The GPU has dropped the page's pictures; the canvas is blank until `onContextRestored`. */
	onContextLost?: () => void;
	onContextRestored?: () => void;

	readonly #canvas: HTMLCanvasElement;
	readonly #renderer: WebGLRenderer;
	readonly #stage = new Stage();
	readonly #turntable: Turntable;
	readonly #loop: FrameLoop;
	#grown: Grown | undefined;
	#spindle: Spindle | undefined;
	#held = false;
	#lost = false;
	#rendered = 0;
	#size = { width: 1, height: 1 };

	/** @throws NoWebGL2Error where the browser has no WebGL 2 */
	constructor(canvas: HTMLCanvasElement, options: BunchViewOptions = {}) {
		this.#canvas = canvas;
		this.#renderer = createRenderer(canvas);
		const slow = drawsBySoftware(this.#renderer.getContext());
		this.#loop = new FrameLoop(({ ratio, now }) => this.#frame(ratio, now), window.devicePixelRatio, slow);
		this.#turntable = new Turntable(canvas, options.reducedMotion ?? false, () => this.#loop.request(true));
		if (options.still) this.#turntable.controls.disconnect();
		this.setTheme(options.theme ?? "light");
		canvas.addEventListener("webglcontextlost", this.#onLost);
		canvas.addEventListener("webglcontextrestored", this.#onRestored);
		this.resize();
		this.#prepare(this.#loop.rest);
		this.#stage.rehearse(this.#renderer, this.camera, this.#turntable.paper);
	}

	/** Shows a bunch in place of the last. Cheap enough for every step of a drag: buffers and programs are reused. */
	show(grown: Grown, look: Look): void {
		this.#stage.show(grown, look);
		this.#grown = grown;
		this.#spindle = spindleOf({ spheres: grown.berries.spheres, points: pointsOf(grown) });
		this.#turntable.follow(this.#spindle, this.#held);
		this.#loop.request(true);
	}

	/** `stems` shows the stems without berries, withered pedicels marked (the paper's figure 14). */
	setMode(mode: Mode): void {
		if (mode === this.#stage.mode) return;
		this.#stage.mode = mode;
		this.#loop.request();
	}

	setTheme(theme: Theme): void {
		this.#stage.theme = theme;
		this.#loop.request();
	}

	/** Fits the drawing to the canvas's size on the page; call it when that changes. */
	resize(): void {
		this.#loop.setDevice(window.devicePixelRatio);
		this.#setSize(this.#canvas.clientWidth || this.#canvas.width, this.#canvas.clientHeight || this.#canvas.height);
		this.#loop.request();
	}

	/** While held (a handle is being dragged), the view stays put however the bunch grows; let go, it follows. */
	holdView(held: boolean): void {
		if (held === this.#held) return;
		this.#held = held;
		if (!held && this.#spindle) this.#turntable.follow(this.#spindle, false);
	}

	/** Turns the bunch, by radians to the right and down. */
	orbit(dx: number, dy: number): void {
		this.#turntable.orbit(dx, dy);
	}

	/** Makes the bunch look `factor` times as large. */
	zoom(factor: number): void {
		this.#turntable.zoom(factor);
	}

	/** Shifts the bunch by shares of the view's height, to the right and down. */
	pan(dx: number, dy: number): void {
		this.#turntable.pan(dx, dy);
	}

	/** The whole bunch, from the direction the page opens with or from a named one. */
	resetView(view?: ViewName): void {
		this.#turntable.fit(view);
	}

	get camera(): PerspectiveCamera {
		return this.#turntable.camera;
	}

	/** Whether pointers turn the bunch; a handle in the scene switches this off while it is dragged. */
	set orbiting(enabled: boolean) {
		this.#turntable.controls.enabled = enabled;
	}

	/** Adds something to the scene, in the bunch's metres. */
	addOverlay(object: Object3D): void {
		this.#stage.scene.add(object);
		this.#loop.request();
	}

	removeOverlay(object: Object3D): void {
		this.#stage.scene.remove(object);
		this.#loop.request();
	}

	/** Where a point of the bunch is on the canvas, in CSS pixels from its top left corner. */
	project(point: Vector3): { x: number; y: number } {
		this.camera.updateMatrixWorld();
		const at = new Vector3().copy(point).project(this.camera);
		return { x: (0.5 + 0.5 * at.x) * this.#size.width, y: (0.5 - 0.5 * at.y) * this.#size.height };
	}

	/**
	 * The berry under a point of the canvas (CSS pixels from its top left corner), as its index in `grown.berries`;
	 * undefined where there is none. Stems hide nothing.
	 */
	pick(x: number, y: number): number | undefined {
		if (!this.#grown || this.#stage.mode !== "whole") return undefined;
		this.camera.updateMatrixWorld();
		const { width, height } = this.#size;
		const eye = this.camera.position;
		const through = new Vector3((2 * x) / width - 1, 1 - (2 * y) / height, 0).unproject(this.camera).sub(eye);
		return pickBerry(this.#grown.berries, { origin: eye.toArray(), direction: through.toArray() });
	}

	/** Marks the berry pointed at, by index; none where undefined. A new bunch starts without a mark. */
	highlight(berry: number | undefined): void {
		if (berry === this.#stage.highlighted) return;
		this.#stage.highlighted = berry;
		this.#loop.request();
	}

	/** Asks for a frame; for overlays that have changed. */
	requestRender(): void {
		this.#loop.request();
	}

	/** How often the scene has been drawn. */
	get rendersCount(): number {
		return this.#rendered;
	}

	/** Settles when nothing is left to draw and the GPU has finished. */
	async whenIdle(): Promise<void> {
		await this.#loop.whenIdle();
		if (!this.#lost) await gpuDone(this.#renderer.getContext() as WebGL2RenderingContext);
	}

	/** The present view as a PNG of the given size in pixels. */
	snapshot(width: number, height: number): Promise<Blob> {
		if (this.#lost) return Promise.reject(new Error("The GPU has been lost; try again when the bunch is back."));
		const { width: shownWidth, height: shownHeight } = this.#size;
		this.#setSize(width, height);
		this.#draw(1);
		const picture = new Promise<Blob>((resolve, reject) => {
			// toBlob copies the pixels before it returns, so that the view can be put back at once.
			this.#canvas.toBlob((blob) => {
				if (blob) resolve(blob);
				else reject(new Error(`The browser made no picture of ${width} × ${height} pixels; try a smaller one.`));
			});
		});
		this.#setSize(shownWidth, shownHeight);
		this.#draw(this.#loop.rest);
		return picture;
	}

	dispose(): void {
		this.#loop.stop();
		this.#canvas.removeEventListener("webglcontextlost", this.#onLost);
		this.#canvas.removeEventListener("webglcontextrestored", this.#onRestored);
		this.#turntable.dispose();
		this.#stage.dispose();
		this.#renderer.dispose();
	}

	readonly #onLost = (event: Event) => {
		event.preventDefault();
		this.#lost = true;
		this.onContextLost?.();
	};

	readonly #onRestored = () => {
		// three sends its buffers, textures and programs again with the next draw.
		this.#lost = false;
		this.#loop.request();
		this.onContextRestored?.();
	};

	#setSize(width: number, height: number): void {
		this.#size = { width: Math.max(1, width), height: Math.max(1, height) };
		this.#turntable.setAspect(this.#size.width / this.#size.height);
	}

	#frame(ratio: number, now: number): boolean {
		const moving = this.#turntable.advance(now);
		this.#draw(ratio);
		return moving;
	}

	#prepare(ratio: number): void {
		this.camera.updateMatrixWorld();
		this.#renderer.setPixelRatio(ratio);
		this.#renderer.setSize(this.#size.width, this.#size.height, false);
	}

	#draw(ratio: number): void {
		if (this.#lost) return;
		this.#prepare(ratio);
		this.#stage.draw(this.#renderer, this.camera, this.#turntable.paper);
		this.#rendered++;
		if (this.#stage.filled && this.onFirstDraw) {
			this.onFirstDraw();
			this.onFirstDraw = undefined;
		}
	}
}

function createRenderer(canvas: HTMLCanvasElement): WebGLRenderer {
	const context = canvas.getContext("webgl2", { antialias: true, alpha: false, powerPreference: "high-performance" });
	if (!context) throw new NoWebGL2Error();
	const renderer = new WebGLRenderer({ canvas, context });
	renderer.outputColorSpace = SRGBColorSpace;
	renderer.toneMapping = NeutralToneMapping;
	renderer.autoClearColor = false;
	// Asking whether a program is sound waits until it is built: only where someone may have broken one.
	renderer.debug.checkShaderErrors = import.meta.env.DEV;
	return renderer;
}

/** Where the bunch is besides its berries: its stems' ends and some of its leaves' points. */
function pointsOf({ internodes, foliage }: Grown): Float32Array {
	if (!foliage) return internodes.ends;
	const leaves = foliage.positions.filter((_, i) => Math.floor(i / 3) % LEAF_POINTS === 0);
	const points = new Float32Array(internodes.ends.length + leaves.length);
	points.set(internodes.ends);
	points.set(leaves, internodes.ends.length);
	return points;
}

/** Whether pictures are drawn without a graphics card: the first ones then start coarse. */
function drawsBySoftware(gl: WebGLRenderingContext | WebGL2RenderingContext): boolean {
	const names = gl.getExtension("WEBGL_debug_renderer_info");
	return (
		names !== null && /swiftshader|llvmpipe|software|basic render/i.test(gl.getParameter(names.UNMASKED_RENDERER_WEBGL))
	);
}

/** Settles when the GPU has done all that was asked of it so far; asks now and then rather than block the page. */
async function gpuDone(gl: WebGL2RenderingContext): Promise<void> {
	const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
	if (!fence) return;
	gl.flush();
	while (gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) await new Promise((resolve) => setTimeout(resolve, 4));
	gl.deleteSync(fence);
}
