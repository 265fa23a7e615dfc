import { FramebufferTexture, LinearFilter, RGBFormat, Vector2, type WebGLRenderer } from "three";
import { FullScreen } from "./full_screen";
import type { Size } from "./size";

/** Blurs pixels along edges, perpendicular to the gradient of brightness, and isolated pixels; other pixels stay. */
const FRAGMENT = /* glsl */ `
varying vec2 place;
uniform sampler2D picture;
uniform vec2 pixel;
uniform ivec2 last;
const vec3 LUMA = vec3(0.299, 0.587, 0.114);
float at_pixel(ivec2 by) {
	return dot(texelFetch(picture, clamp(ivec2(gl_FragCoord.xy) + by, ivec2(0), last), 0).rgb, LUMA);
}
vec3 corner(float x, float y) {
	return texture2D(picture, 0.5 * place + 0.5 + vec2(x, y) * pixel).rgb;
}
vec3 pair(vec2 run, float by) {
	vec2 at = 0.5 * place + 0.5;
	return 0.5 * (texture2D(picture, at + run * by).rgb + texture2D(picture, at - run * by).rgb);
}
void main() {
	vec3 colour = texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb;
	float middle = dot(colour, LUMA);
	vec4 beside = vec4(at_pixel(ivec2(0, 1)), at_pixel(ivec2(1, 0)), at_pixel(ivec2(0, -1)), at_pixel(ivec2(-1, 0)));
	float least = min(middle, min(min(beside.x, beside.y), min(beside.z, beside.w)));
	float most = max(middle, max(max(beside.x, beside.y), max(beside.z, beside.w)));
	if (most - least > max(0.06, 0.15 * most)) {
		mat4x3 around = mat4x3(corner(-0.5, 0.5), corner(0.5, 0.5), corner(-0.5, -0.5), corner(0.5, -0.5));
		vec4 corners = LUMA * around;
		vec2 run = vec2(corners.z + corners.w - corners.x - corners.y, corners.x + corners.z - corners.y - corners.w);
		float flat_ = max(0.03 * (corners.x + corners.y + corners.z + corners.w), 0.008);
		run = clamp(run / (min(abs(run.x), abs(run.y)) + flat_), -6.0, 6.0) * pixel;
		vec3 near = pair(run, 1.0 / 6.0);
		vec3 far = 0.5 * near + 0.5 * pair(run, 0.5);
		float reached = dot(far, LUMA);
		colour = reached < least || reached > most ? near : far;
		// Objects thinner than a pixel, such as a leaf in a crown, have no edge direction: they get the mean of their
		// neighbours.
		float alone = abs(middle - dot(beside, vec4(0.25))) / (most - least);
		colour = mix(colour, around * vec4(0.25), clamp((alone - 0.25) / 0.5, 0.0, 1.0));
	}
	gl_FragColor = vec4(colour, 1.0);
}
`;

/**
 * Antialiasing after drawing: blurs along edges (Lottes 2009, "FXAA", the short form, with the long form's treatment
 * of single pixels). The cost does not depend on the picture; with multisampling, software would shade every
 * triangle's edge several times.
 */
export class SmoothEdges {
	readonly #screen = new FullScreen({
		name: "smooth-edges",
		fragmentShader: FRAGMENT,
		uniforms: { picture: { value: null }, pixel: { value: new Vector2() }, last: { value: new Vector2() } },
	});
	#picture: FramebufferTexture | undefined;

	/** Smooths the picture in the lower left corner of the canvas. */
	draw(renderer: WebGLRenderer, size: Size): void {
		const picture = this.#pictureOf(size);
		renderer.copyFramebufferToTexture(picture);
		const { uniforms } = this.#screen;
		uniforms.picture.value = picture;
		uniforms.pixel.value.set(1 / size.width, 1 / size.height);
		uniforms.last.value.set(size.width - 1, size.height - 1);
		this.#screen.draw(renderer);
	}

	/** Releases the graphics memory. */
	dispose(): void {
		this.#picture?.dispose();
		this.#screen.dispose();
	}

	/** Returns the texture that holds the drawn picture, recreated when the size changes. */
	#pictureOf({ width, height }: Size): FramebufferTexture {
		const { image } = this.#picture ?? {};
		if (this.#picture && image?.width === width && image.height === height) return this.#picture;
		this.#picture?.dispose();
		const made = new FramebufferTexture(width, height);
		// RGB, because the canvas has no alpha.
		made.format = RGBFormat;
		made.internalFormat = "RGB8";
		made.magFilter = LinearFilter;
		made.minFilter = LinearFilter;
		this.#picture = made;
		return made;
	}
}
