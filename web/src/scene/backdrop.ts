import { type Mesh, type Texture, Vector3 } from "three";
import { linear } from "../plant/colour";
import { FullScreen } from "./full_screen";
import type { LightRig } from "./light";

/** Paper: a pool of light that comes from the key's side, the plant's shadow, a breath of grain against banding. */
const FRAGMENT = /* glsl */ `
varying vec2 place;
uniform sampler2D shadowMap;
uniform vec3 edge;
uniform vec3 pool;
uniform vec3 shade;
uniform float shadow;
uniform float aspect;
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
	gl_FragColor = vec4(paper, 1.0);
	#include <colorspace_fragment>
	gl_FragColor.rgb += grain(gl_FragCoord.xy) * (shadow > 0.0 ? 0.006 : 0.0);
}
`;

/** The paper behind everything; not tone-mapped, so that its edges are exactly the page's colour. */
export class Backdrop {
	readonly #paper: FullScreen;

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
			},
			behind: true,
		});
		// After the plant: the depth test then spares the pixels that it covers.
		this.mesh.renderOrder = 2;
	}

	get mesh(): Mesh {
		return this.#paper.mesh;
	}

	setRig(rig: LightRig): void {
		const { uniforms } = this.#paper;
		uniforms.edge.value.fromArray(linear(rig.paper.edge));
		uniforms.pool.value.fromArray(linear(rig.paper.pool));
		uniforms.shadow.value = rig.shadow.depth;
	}

	/** Flat black or white in place of the paper, without shadow or grain. */
	setFlat(grey: 0 | 1): void {
		const { uniforms } = this.#paper;
		uniforms.edge.value.setScalar(grey);
		uniforms.pool.value.setScalar(grey);
		uniforms.shadow.value = 0;
	}

	setAspect(aspect: number): void {
		this.#paper.uniforms.aspect.value = aspect;
	}

	dispose(): void {
		this.#paper.dispose();
	}
}
