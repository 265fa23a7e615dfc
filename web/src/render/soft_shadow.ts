import {
	LinearFilter,
	LinearMipmapLinearFilter,
	type PerspectiveCamera,
	type Scene,
	type WebGLRenderer,
	WebGLRenderTarget,
} from "three";
import { FullScreen } from "./full_screen";

/** Pixels along the hard shadow's shorter side, so that stalks are not missed. */
const RESOLUTION = 400;

/**
 * Estimates for each pixel the distance to the objects that cast the shadow, first over a large area and then over
 * smaller ones, and averages over the lamp's disc as seen from there (Fernando 2005, "Percentage-closer soft shadows",
 * on an image of the shadow).
 */
const FRAGMENT = /* glsl */ `
varying vec2 place;
uniform sampler2D hard;
uniform vec2 size;
uniform float softness;
vec2 seen(vec2 at, float pixels) {
	return textureLod(hard, at, log2(max(1.0, pixels))).rg;
}
void main() {
	vec2 at = 0.5 * place + 0.5;
	float radius = softness;
	for (int look = 0; look < 3; look++) {
		vec2 aside = radius / size;
		vec2 found = seen(at, radius) + seen(at + aside * vec2(0.7, 0.2), radius) + seen(at + aside * vec2(-0.2, 0.7), radius)
			+ seen(at + aside * vec2(-0.7, -0.2), radius) + seen(at + aside * vec2(0.2, -0.7), radius);
		if (found.r < 1e-3) break;
		radius = max(1.0, softness * found.g / found.r);
	}
	float hidden = 0.0, weights = 0.0;
	for (int i = 0; i < 24; i++) {
		float out_ = sqrt((float(i) + 0.5) / 24.0), turn = 2.39996323 * float(i);
		float weight = 1.0 - 0.7 * out_ * out_;
		hidden += weight * seen(at + radius * out_ * vec2(cos(turn), sin(turn)) / size, 0.5 * radius).r;
		weights += weight;
	}
	gl_FragColor = vec4(vec3(1.0 - hidden / weights), 1.0);
}
`;

/** Softens hard shadows as from a point light to those of an area light: the farther from the object, the softer. */
export class SoftShadow {
	readonly #target = new WebGLRenderTarget(1, 1, {
		depthBuffer: false,
		generateMipmaps: true,
		magFilter: LinearFilter,
		minFilter: LinearMipmapLinearFilter,
	});
	readonly #screen = new FullScreen({
		name: "soft-shadow",
		fragmentShader: FRAGMENT,
		uniforms: { hard: { value: this.#target.texture }, size: { value: [1, 1] }, softness: { value: 0 } },
	});

	/**
	 * Draws the remaining light, 1 to 0, into `onto`.
	 * @param hard scene of the casting objects; draws 1, and the distance between object and paper over half the
	 * paper's distance
	 * @param spread tangent of the lamp's apparent radius
	 */
	draw(renderer: WebGLRenderer, hard: Scene, camera: PerspectiveCamera, spread: number, onto: WebGLRenderTarget): void {
		const height = camera.aspect >= 1 ? RESOLUTION : Math.round(RESOLUTION / camera.aspect);
		const width = Math.round(height * camera.aspect);
		this.#target.setSize(width, height);
		renderer.setRenderTarget(this.#target);
		renderer.setClearColor(0x000000, 1);
		renderer.clear();
		renderer.render(hard, camera);
		const { uniforms } = this.#screen;
		uniforms.size.value = [width, height];
		// A length of half the paper's distance, in pixels, at that distance.
		uniforms.softness.value = spread * 0.25 * camera.projectionMatrix.elements[5] * height;
		renderer.setRenderTarget(onto);
		this.#screen.draw(renderer);
	}

	/** Releases the graphics memory. */
	dispose(): void {
		this.#target.dispose();
		this.#screen.dispose();
	}
}
