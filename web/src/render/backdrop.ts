import { type Mesh, type PerspectiveCamera, type Texture, Vector2, Vector3 } from "three";
import { linear } from "../plant/colour";
import { FullScreen } from "./full_screen";
import type { LightRig } from "./light";

/** Rate at which the horizon's colour fades towards the zenith. */
const SKY_RISE = 3;

/**
 * Paper: a pool of light on the key light's side, the plant's shadow, and slight grain against banding. For a viewer
 * within the plant, a sky.
 */
const FRAGMENT = /* glsl */ `
varying vec2 place;
uniform sampler2D shadowMap;
uniform vec3 edge;
uniform vec3 pool;
uniform vec3 shade;
uniform float shadow;
uniform float aspect;
uniform float sky;
uniform vec3 horizon;
uniform vec3 zenith;
uniform vec2 sight;
uniform vec3 rise;
float grain(vec2 at) {
	uvec2 c = uvec2(at) * uvec2(0x9e3779b1u, 0x85ebca6bu);
	uint h = (c.x ^ c.y) * 0x27d4eb2du;
	return float((h ^ (h >> 15u)) & 0xffffu) / 65535.0 - 0.5;
}
void main() {
	vec2 from = (place - vec2(-0.18, 0.16)) * vec2(min(aspect, 1.35), 1.0);
	float near = exp(-1.5 * dot(from, from));
	vec3 paper = mix(edge, pool, near);
	float hidden = 1.0 - texture2D(shadowMap, 0.5 * place + 0.5).r;
	// The shadow fades out before the view's edge so that no edge ever cuts it.
	vec2 rim = 1.0 - smoothstep(vec2(0.7), vec2(1.02), abs(place));
	paper *= mix(vec3(1.0), shade, shadow * hidden * rim.x * rim.y);
	float high = dot(rise, vec3(place, 1.0)) / length(vec3(sight * place, 1.0));
	vec3 above = mix(zenith, horizon, exp(-${SKY_RISE.toFixed(1)} * max(high, 0.0)));
	gl_FragColor = vec4(mix(paper, above, sky), 1.0);
	#include <colorspace_fragment>
	gl_FragColor.rgb += grain(gl_FragCoord.xy) * (shadow + sky > 0.0 ? 0.006 : 0.0);
}
`;

/** The background; not tone-mapped, so that its edges have exactly the page's colour. */
export class Backdrop {
	readonly #paper: FullScreen;
	/** Whether the background is a flat colour. */
	#flat = false;

	/** @param shadowMap the plant's shadow as the camera sees it; red is the share of light that passes */
	constructor(shadowMap: Texture) {
		this.#paper = new FullScreen({
			name: "backdrop",
			fragmentShader: FRAGMENT,
			uniforms: {
				shadowMap: { value: shadowMap },
				edge: { value: new Vector3() },
				pool: { value: new Vector3() },
				shade: { value: new Vector3(0.42, 0.36, 0.34) },
				shadow: { value: 0 },
				aspect: { value: 1 },
				sky: { value: 0 },
				horizon: { value: new Vector3() },
				zenith: { value: new Vector3() },
				sight: { value: new Vector2(1, 1) },
				rise: { value: new Vector3() },
			},
			behind: true,
		});
		// Drawn after the plant, so that the depth test skips covered pixels.
		this.mesh.renderOrder = 2;
	}

	/** The triangle behind the plant, which the stage adds to its scene. */
	get mesh(): Mesh {
		return this.#paper.mesh;
	}

	/** Takes the colours of the paper and the sky, and the depth of the shadow, from a light rig; ends `setFlat`. */
	setRig(rig: LightRig): void {
		const { uniforms } = this.#paper;
		uniforms.edge.value.fromArray(linear(rig.paper.edge));
		uniforms.pool.value.fromArray(linear(rig.paper.pool));
		uniforms.shadow.value = rig.shadow.depth;
		uniforms.horizon.value.fromArray(linear(rig.sky.horizon));
		uniforms.zenith.value.fromArray(linear(rig.sky.zenith));
		this.#flat = false;
	}

	/** Shows flat black or white in place of the paper, without shadow or grain. */
	setFlat(grey: 0 | 1): void {
		const { uniforms } = this.#paper;
		uniforms.edge.value.setScalar(grey);
		uniforms.pool.value.setScalar(grey);
		uniforms.shadow.value = 0;
		this.#flat = true;
	}

	/** Shows a sky as seen by the camera; undefined shows the paper again. */
	setSky(camera: PerspectiveCamera | undefined): void {
		const { sky, sight, rise } = this.#paper.uniforms;
		sky.value = camera && !this.#flat ? 1 : 0;
		if (!camera) return;
		const up = Math.tan((camera.fov * Math.PI) / 360);
		sight.value.set(up * camera.aspect, up);
		// World y of the camera's axes: how much the direction rises across the view.
		const { elements } = camera.matrixWorld;
		rise.value.set(up * camera.aspect * elements[1], up * elements[5], -elements[9]);
	}

	/** Sets the view's aspect ratio (width / height). */
	setAspect(aspect: number): void {
		this.#paper.uniforms.aspect.value = aspect;
	}

	/** Releases the graphics memory. */
	dispose(): void {
		this.#paper.dispose();
	}
}
