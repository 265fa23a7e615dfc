import {
	BufferAttribute,
	CustomBlending,
	InstancedBufferGeometry,
	LinearFilter,
	Mesh,
	OneMinusSrcAlphaFactor,
	type PerspectiveCamera,
	Scene,
	ShaderMaterial,
	Vector3,
	type WebGLRenderer,
	WebGLRenderTarget,
	ZeroFactor,
} from "three";
import { RECORD_CHUNK, type SharedUniforms } from "./light_shader";

/** Pixels along the target's shorter side; the shadow is soft, so more would show nothing new. */
const RESOLUTION = 104;

/**
 * Each berry and internode lays a soft capsule on the paper: the paper faces the viewer at depth `paper` (view space,
 * negative), the shadow goes there along the key light and is as soft as it has come far.
 */
const VERTEX = /* glsl */ `
uniform int berries;
uniform int firstReceiver;
uniform float paper;
uniform vec3 lamp;
uniform float spread;
varying vec2 at;
varying vec2 capsule;
${RECORD_CHUNK}
vec2 landing(vec3 from, out float way) {
	way = max(0.0, from.z - paper) / lamp.z;
	return from.xy - lamp.xy * way;
}
void main() {
	int receiver = firstReceiver + gl_InstanceID;
	vec4 middle = receiver_texel(receiver, 0);
	vec4 axis = receiver_texel(receiver, 1);
	bool round = receiver < berries;
	vec4 form = receiver_texel(receiver, 4);
	vec3 along = round ? axis.xyz * max(0.0, form.y - form.x) : axis.xyz;
	float radius = round ? form.x : axis.w;
	float way, other;
	vec2 from = landing((viewMatrix * vec4(middle.xyz - along, 1.0)).xyz, way);
	vec2 to = landing((viewMatrix * vec4(middle.xyz + along, 1.0)).xyz, other);
	float blur = spread * 0.5 * (way + other);
	float reach = radius + blur;
	vec2 run = to - from;
	float span = length(run);
	vec2 u = span > 1e-6 ? run / span : vec2(1.0, 0.0);
	capsule = vec2(0.5 * span, radius) / reach;
	at = position.xy * vec2(capsule.x + 1.0, 1.0);
	vec2 place = 0.5 * (from + to) + reach * (u * at.x + vec2(-u.y, u.x) * at.y);
	gl_Position = projectionMatrix * vec4(place, paper, 1.0);
	// Among berries only rachis and axes show; the many short stems would cost more than all else.
	if (!round && firstReceiver == 0 && receiver_texel(receiver, 2).y > 1.5) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
varying vec2 at;
varying vec2 capsule;
void main() {
	float away = length(vec2(max(0.0, abs(at.x) - capsule.x), at.y));
	// What a disc of radius b leaves of a soft edge: full while the lamp is hidden, least of all for thin stems.
	float most = min(1.0, 2.2 * capsule.y);
	float soft = 1.0 - smoothstep(max(0.0, 2.0 * capsule.y - 1.0), 1.0, away);
	gl_FragColor = vec4(0.0, 0.0, 0.0, most * soft);
}
`;

/** The bunch's shadow on the paper, drawn small and read back by the backdrop. */
export class CastShadow {
	readonly target = new WebGLRenderTarget(1, 1, {
		depthBuffer: false,
		magFilter: LinearFilter,
		minFilter: LinearFilter,
	});
	readonly #material: ShaderMaterial;
	readonly #geometry = new InstancedBufferGeometry();
	readonly #scene = new Scene();

	constructor(shared: SharedUniforms) {
		this.#material = new ShaderMaterial({
			name: "cast-shadow",
			vertexShader: VERTEX,
			fragmentShader: FRAGMENT,
			uniforms: {
				...shared,
				berries: { value: 0 },
				firstReceiver: { value: 0 },
				paper: { value: -1 },
				lamp: { value: new Vector3(0, 0, 1) },
				spread: { value: 0.3 },
			},
			blending: CustomBlending,
			blendSrc: ZeroFactor,
			blendDst: OneMinusSrcAlphaFactor,
			depthTest: false,
			depthWrite: false,
			toneMapped: false,
		});
		const corners = new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]);
		this.#geometry.setAttribute("position", new BufferAttribute(corners, 3));
		this.#geometry.setIndex([0, 1, 2, 0, 2, 3]);
		const mesh = new Mesh(this.#geometry, this.#material);
		mesh.frustumCulled = false;
		this.#scene.add(mesh);
	}

	/** @param lamp direction to the key light in view space, and the tangent of its apparent radius */
	setLamp(lamp: Vector3, spread: number): void {
		this.#material.uniforms.lamp.value.copy(lamp);
		this.#material.uniforms.spread.value = spread;
	}

	/**
	 * Draws the shadow as `camera` sees it.
	 * @param paper distance of the paper from the camera
	 * @param withBerries false for bare stems
	 */
	draw(
		renderer: WebGLRenderer,
		camera: PerspectiveCamera,
		receivers: { count: number; berries: number },
		paper: number,
		withBerries: boolean,
	): void {
		const height = camera.aspect >= 1 ? RESOLUTION : Math.round(RESOLUTION / camera.aspect);
		this.target.setSize(Math.round(height * camera.aspect), height);
		const { uniforms } = this.#material;
		uniforms.berries.value = receivers.berries;
		uniforms.firstReceiver.value = withBerries ? 0 : receivers.berries;
		uniforms.paper.value = -paper;
		this.#geometry.instanceCount = receivers.count - uniforms.firstReceiver.value;
		renderer.setRenderTarget(this.target);
		renderer.setClearColor(0xffffff, 1);
		renderer.clear();
		renderer.render(this.#scene, camera);
		renderer.setRenderTarget(null);
	}

	dispose(): void {
		this.target.dispose();
		this.#material.dispose();
		this.#geometry.dispose();
	}
}
