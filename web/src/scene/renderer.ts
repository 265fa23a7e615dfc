/** The renderer, and what there is to know of the graphics card behind it. */
import { NeutralToneMapping, SRGBColorSpace, WebGLRenderer } from "three";
import { NoWebGL2Error } from "./no_webgl2";

/**
 * @param checked whether programs are checked for errors
 * @throws NoWebGL2Error where the browser has no WebGL 2
 */
export function createRenderer(canvas: HTMLCanvasElement, checked: boolean): WebGLRenderer {
	const context = canvas.getContext("webgl2", { antialias: true, alpha: false, powerPreference: "high-performance" });
	if (!context) throw new NoWebGL2Error();
	const renderer = new WebGLRenderer({ canvas, context });
	renderer.outputColorSpace = SRGBColorSpace;
	renderer.toneMapping = NeutralToneMapping;
	renderer.autoClearColor = false;
	// Asking whether a program is sound waits until it is built: only where someone may have broken one.
	renderer.debug.checkShaderErrors = checked;
	return renderer;
}

/** Whether pictures are drawn without a graphics card: the first ones then start coarse. */
export function drawsBySoftware(gl: WebGLRenderingContext | WebGL2RenderingContext): boolean {
	const names = gl.getExtension("WEBGL_debug_renderer_info");
	return (
		names !== null && /swiftshader|llvmpipe|software|basic render/i.test(gl.getParameter(names.UNMASKED_RENDERER_WEBGL))
	);
}

/** Settles when the GPU has done all that was asked of it so far; asks now and then rather than block the page. */
export async function gpuDone(gl: WebGL2RenderingContext): Promise<void> {
	const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
	if (!fence) return;
	gl.flush();
	while (gl.clientWaitSync(fence, 0, 0) === gl.TIMEOUT_EXPIRED) await new Promise((resolve) => setTimeout(resolve, 4));
	gl.deleteSync(fence);
}
