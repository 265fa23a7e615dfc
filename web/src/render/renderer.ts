/** The WebGL renderer, and properties of its graphics card. */
import { NeutralToneMapping, type PerspectiveCamera, SRGBColorSpace, WebGLRenderer } from "three";
import { NoWebGL2Error } from "./no_webgl2";
import type { Size } from "./size";
import { SmoothEdges } from "./smooth_edges";

/** Something that a renderer draws: a `Stage`. */
export interface Drawable {
	/** Draws itself. @param paper distance of the paper from the eye */
	draw(renderer: WebGLRenderer, camera: PerspectiveCamera, paper: number): void;
}

/**
 * Context of the graphics card. Browsers allow about sixteen contexts per page. A page with many views makes one
 * renderer for all of them (`ViewerOptions.renderer`), and each view copies its picture to its own canvas.
 */
export class Renderer {
	/** Whether WebGL runs in software: the first pictures are then coarse. */
	readonly slow: boolean;
	readonly #three: WebGLRenderer;
	readonly #edges: SmoothEdges | undefined;
	readonly #fits: boolean;

	/**
	 * @param canvas canvas of the only view, resized to each picture; if absent, the renderer has a canvas of its own,
	 * large enough for the largest view
	 * @param checked whether programs are checked for errors, which waits until they are compiled
	 * @throws NoWebGL2Error if the browser has no WebGL 2
	 */
	constructor(canvas?: HTMLCanvasElement, checked = false) {
		this.#fits = canvas !== undefined;
		const drawn = canvas ?? document.createElement("canvas");
		this.slow = drawsBySoftware();
		const wanted = {
			antialias: !this.slow,
			alpha: false,
			powerPreference: "high-performance",
		} satisfies WebGLContextAttributes;
		const context = drawn.getContext("webgl2", wanted) as WebGL2RenderingContext | null;
		if (!context) throw new NoWebGL2Error();
		this.#three = new WebGLRenderer({ canvas: drawn, context });
		this.#three.outputColorSpace = SRGBColorSpace;
		this.#three.toneMapping = NeutralToneMapping;
		this.#three.autoClearColor = false;
		this.#three.shadowMap.enabled = true;
		this.#three.debug.checkShaderErrors = checked;
		// Multisampling would double software's time per frame, so edges are smoothed afterwards.
		if (this.slow) this.#edges = new SmoothEdges();
	}

	/** Canvas of the context; pictures are in its lower left corner. */
	get canvas(): HTMLCanvasElement {
		return this.#three.domElement;
	}

	/** Whether the context is lost; the canvas's event `webglcontextrestored` announces its return. */
	get lost(): boolean {
		return this.#three.getContext().isContextLost();
	}

	/** Numbers of geometries, textures and programs on the card. */
	get held(): { geometries: number; textures: number; programs: number } {
		const { memory, programs } = this.#three.info;
		return { geometries: memory.geometries, textures: memory.textures, programs: programs?.length ?? 0 };
	}

	/** Draws into the lower left corner of its canvas. @param paper distance of the paper from the eye */
	draw(stage: Drawable, camera: PerspectiveCamera, paper: number, size: Size): void {
		this.fit(size);
		stage.draw(this.#three, camera, paper);
		this.#edges?.draw(this.#three, size);
	}

	/** Resizes the canvas for a picture: to its size if the canvas has one view only, else at least to its size. */
	fit({ width, height }: Size): void {
		const { canvas } = this;
		const [across, up] = this.#fits
			? [width, height]
			: [Math.max(canvas.width, width), Math.max(canvas.height, height)];
		if (across !== canvas.width || up !== canvas.height) this.#three.setSize(across, up, false);
		this.#three.setViewport(0, 0, width, height);
	}

	/** Runs a function with three's renderer, for drawings that are not on the canvas. */
	use<Result>(draw: (renderer: WebGLRenderer) => Result): Result {
		return draw(this.#three);
	}

	/** Copies the last picture onto a view's canvas; call it in the same task, before the browser clears the canvas. */
	copy(onto: CanvasRenderingContext2D, { width, height }: Size): void {
		const { canvas } = onto;
		if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
		onto.drawImage(this.canvas, 0, this.canvas.height - height, width, height, 0, 0, width, height);
	}

	/** Resolves when the graphics card has finished all commands so far. */
	async done(): Promise<void> {
		if (!this.lost) await gpuDone(this.#three.getContext() as WebGL2RenderingContext);
	}

	/** Releases the context; the canvas cannot be drawn on again. */
	dispose(): void {
		this.#edges?.dispose();
		this.#three.dispose();
		// Browsers release contexts late.
		this.#three.forceContextLoss();
	}
}

/** Whether WebGL 2 runs in software; undefined before the first check. */
let software: boolean | undefined;

/**
 * Returns whether WebGL 2 runs in software. Checks this once with a context of its own, because antialiasing must be
 * chosen before the drawing context exists.
 * @throws NoWebGL2Error
 */
function drawsBySoftware(): boolean {
	if (software !== undefined) return software;
	const gl = document.createElement("canvas").getContext("webgl2", { antialias: false });
	if (!gl) throw new NoWebGL2Error();
	const names = gl.getExtension("WEBGL_debug_renderer_info");
	software =
		names !== null &&
		/swiftshader|llvmpipe|software|basic render/i.test(gl.getParameter(names.UNMASKED_RENDERER_WEBGL));
	gl.getExtension("WEBGL_lose_context")?.loseContext();
	return software;
}

/** Resolves when the GPU has finished all commands so far; polls, so that the page is not blocked. */
async function gpuDone(gl: WebGL2RenderingContext): Promise<void> {
	const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
	if (!fence) return;
	gl.flush();
	while (gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) await new Promise((resolve) => setTimeout(resolve, 4));
	gl.deleteSync(fence);
}
