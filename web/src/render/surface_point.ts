/** Finds the point of the drawn scene at a pixel, by its depth: correct for every model's own way of drawing. */
import {
	DepthTexture,
	NearestFilter,
	type PerspectiveCamera,
	type Scene,
	SRGBColorSpace,
	Vector3,
	type WebGLRenderer,
	WebGLRenderTarget,
} from "three";
import { FullScreen } from "./full_screen";
import type { SceneVector } from "./model_renderer";
import type { Size } from "./size";

/** Writes the depth, 0 … 1, as three bytes. */
const FRAGMENT = /* glsl */ `
uniform highp sampler2D depth;
void main() {
	// Limited, because a sum near 2^24 is rounded up.
	uint steps = uint(min(round(texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r * 16777215.0), 16777215.0));
	gl_FragColor = vec4(uvec4(steps >> 16u, (steps >> 8u) & 255u, steps & 255u, 255u)) / 255.0;
}
`;
/** Depth of the background. */
const FAR = 0xffffff;

/** A pixel of the view, CSS pixels from its top left corner, and the radius around it in which points are found. */
export interface PixelArea {
	readonly x: number;
	readonly y: number;
	readonly reach: number;
}

/**
 * Draws a small square of the view and returns the scene's point in the covered pixel nearest to its middle, metres;
 * undefined if nothing is drawn in the circle.
 * @param size of the view, CSS pixels
 */
export function surfacePoint(
	renderer: WebGLRenderer,
	scene: Scene,
	camera: PerspectiveCamera,
	size: Size,
	area: PixelArea,
): SceneVector | undefined {
	const side = 2 * Math.ceil(area.reach) + 1;
	const [left, top] = [Math.round(area.x - side / 2), Math.round(area.y - side / 2)];
	const part = camera.clone();
	part.setViewOffset(size.width, size.height, left, top, side, side);
	const depths = depthsOf(renderer, scene, part, side);
	let nearest = area.reach + 0.5;
	let found: Vector3 | undefined;
	for (let row = 0; row < side; row++)
		for (let column = 0; column < side; column++) {
			const depth = depths[side * row + column];
			// Rows are read from below.
			const [x, y] = [left + column + 0.5, top + side - row - 0.5];
			const distance = Math.hypot(x - area.x, y - area.y);
			if (depth === FAR || distance > nearest) continue;
			nearest = distance;
			found = new Vector3((2 * x) / size.width - 1, 1 - (2 * y) / size.height, (2 * depth) / FAR - 1);
		}
	return found?.unproject(camera).toArray();
}

/** Returns the depths that a camera sees, from 0 to `FAR`, row by row from below. */
function depthsOf(renderer: WebGLRenderer, scene: Scene, camera: PerspectiveCamera, side: number): Uint32Array {
	const drawn = new WebGLRenderTarget(side, side, { depthTexture: new DepthTexture(side, side) });
	// Like the canvas for three.js, so that it uses the canvas's programs instead of compiling others.
	Object.assign(drawn, { isXRRenderTarget: true });
	drawn.texture.colorSpace = SRGBColorSpace;
	const packed = new WebGLRenderTarget(side, side, { depthBuffer: false, minFilter: NearestFilter });
	const screen = new FullScreen({
		name: "depths",
		fragmentShader: FRAGMENT,
		uniforms: { depth: { value: drawn.depthTexture } },
	});
	try {
		renderer.setRenderTarget(drawn);
		renderer.render(scene, camera);
		renderer.setRenderTarget(packed);
		screen.draw(renderer);
		const bytes = new Uint8Array(4 * side * side);
		renderer.readRenderTargetPixels(packed, 0, 0, side, side, bytes);
		return Uint32Array.from(
			{ length: side * side },
			(_, i) => (bytes[4 * i] << 16) | (bytes[4 * i + 1] << 8) | bytes[4 * i + 2],
		);
	} finally {
		renderer.setRenderTarget(null);
		drawn.depthTexture?.dispose();
		for (const each of [drawn, packed, screen]) each.dispose();
	}
}
