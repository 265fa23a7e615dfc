import {
	BufferAttribute,
	CustomBlending,
	InstancedBufferGeometry,
	Mesh,
	OneMinusSrcAlphaFactor,
	ShaderMaterial,
	ZeroFactor,
} from "three";
import type { PaperShadow } from "./paper_shadow";
import { fillInstances } from "./streams";
import { WIND_CHUNK, type WindUniforms } from "./wind_shader";

/** Capsules: cylinders with round ends. Metres. */
export interface Capsules {
	count: number;
	/** 4 × count: beginning of the axis, radius. */
	begins: Float32Array;
	/** 3 × count: end of the axis. */
	ends: Float32Array;
}

/** Each instance draws a soft capsule on the paper. */
const VERTEX = /* glsl */ `
attribute vec4 begins;
attribute vec3 ends;
uniform float paper;
uniform vec3 lamp;
uniform float spread;
varying vec2 at;
varying vec2 capsule;
${WIND_CHUNK}
vec2 landing(vec3 from, out float way) {
	way = max(0.0, from.z - paper) / lamp.z;
	return from.xy - lamp.xy * way;
}
void main() {
	float way, other;
	vec2 from = landing((viewMatrix * vec4(blown(begins.xyz, begins.xyz), 1.0)).xyz, way);
	vec2 to = landing((viewMatrix * vec4(blown(ends, ends), 1.0)).xyz, other);
	float blur = spread * 0.5 * (way + other);
	float reach = begins.w + blur;
	vec2 run = to - from;
	float span = length(run);
	vec2 u = span > 1e-6 ? run / span : vec2(1.0, 0.0);
	capsule = vec2(0.5 * span, begins.w) / reach;
	at = position.xy * vec2(capsule.x + 1.0, 1.0);
	vec2 place = 0.5 * (from + to) + reach * (u * at.x + vec2(-u.y, u.x) * at.y);
	gl_Position = projectionMatrix * vec4(place, paper, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
varying vec2 at;
varying vec2 capsule;
void main() {
	float away = length(vec2(max(0.0, abs(at.x) - capsule.x), at.y));
	// Darkness under a disc of radius b with a soft edge: full while the lamp is hidden, least for thin stems.
	float most = min(1.0, 2.2 * capsule.y);
	float soft = 1.0 - smoothstep(max(0.0, 2.0 * capsule.y - 1.0), 1.0, away);
	gl_FragColor = vec4(0.0, 0.0, 0.0, most * soft);
}
`;

/** Shadow of a plant whose bodies are nearly capsules: soft by a formula, one quad per body. */
export class CapsuleShadow {
	readonly #mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;

	/**
	 * Adds a mesh to the shadow's scene: one square per capsule, whose shader multiplies the light that passes (blending
	 * by destination × (1 − source alpha)).
	 */
	constructor(shadow: PaperShadow, wind: WindUniforms) {
		const geometry = new InstancedBufferGeometry();
		const corners = new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]);
		geometry.setAttribute("position", new BufferAttribute(corners, 3));
		geometry.setIndex([0, 1, 2, 0, 2, 3]);
		const material = new ShaderMaterial({
			name: "capsule-shadow",
			vertexShader: VERTEX,
			fragmentShader: FRAGMENT,
			uniforms: { ...shadow.uniforms, ...wind },
			blending: CustomBlending,
			blendSrc: ZeroFactor,
			blendDst: OneMinusSrcAlphaFactor,
			depthTest: false,
			depthWrite: false,
			toneMapped: false,
		});
		this.#mesh = new Mesh(geometry, material);
		this.#mesh.frustumCulled = false;
		shadow.root.add(this.#mesh);
	}

	/** Replaces the bodies that cast the shadow. */
	set({ count, begins, ends }: Capsules): void {
		const { geometry } = this.#mesh;
		fillInstances(geometry, "begins", begins, 4);
		fillInstances(geometry, "ends", ends, 3);
		geometry.instanceCount = count;
		this.#mesh.visible = count > 0;
	}

	/** Removes the mesh from the shadow's scene and frees its GPU resources. */
	dispose(): void {
		this.#mesh.removeFromParent();
		this.#mesh.geometry.dispose();
		this.#mesh.material.dispose();
	}
}
