/**
 * The ground under a standing plant: a patch that fades into the paper, or outdoors a meadow up to the horizon. It
 * receives the plant's shadow, and is darker at the foot of stems and below the crown.
 */
import {
	BufferAttribute,
	BufferGeometry,
	Mesh,
	type MeshStandardMaterial,
	type PerspectiveCamera,
	Vector3,
	Vector4,
	type WebGLProgramParametersWithUniforms,
} from "three";
import { type Colour, linear } from "../../plant/colour";
import { type Footing, MAX_STEMS } from "../../plant/footing";
import { NOISE_CHUNK } from "../../plant/noise";
import { float } from "../glsl";
import type { LightUniforms } from "../light_shader";
import { standardMaterial } from "../standard_material";

/** Colour of the patch on the paper: short dry grass. */
const PATCH = linear("a5a077");
/** Radius of the patch, as factors on the plant's reach and height, whichever is larger, and where it begins to fade. */
const PATCH_REACH = 1.25;
const PATCH_HEIGHT = 0.42;
const PATCH_INNER = 0.3;
/** Radius of the meadow as a share of the camera's depth of view, and distance at which half of it is haze, metres. */
const MEADOW = 0.9;
const HAZE = 170;
/** Height of the centre of a crown's shade over the ground, as a share of the plant's height. */
const CROWN_HEIGHT = 0.45;
/** The ground is this much below the plant's foot, as a share of its height, so that fallen leaves lie on it. */
const SINK = 0.0005;
/** Height of the grass, metres, and steps of the line of sight through it. */
const GRASS = 0.16;
const GRASS_STEPS = 6;
/** Pixels of a view's height for which the detail is chosen. */
const PIXELS = 900;
/** Triangles round the disc. */
const ROUND = 64;

/**
 * Open sky over the ground, 0 … 1, as `openBesideStem` (plant/footing.ts) for each stem, times that of the crown, seen
 * as a disc at a height: a disc of radius R at height h hides R² / (R² + h²) of the sky from the point below its centre.
 */
const OPEN = /* glsl */ `
float ground_open(vec2 at) {
	float open = 1.0;
	for (int i = 0; i < ${MAX_STEMS}; i++) {
		if (stems[i].z <= 0.0) break;
		open *= 1.0 - asin(min(1.0, stems[i].z / max(1e-5, distance(at, stems[i].xy)))) / PI;
	}
	float away = dot(at - crown.xy, at - crown.xy);
	float high = crownHeight * crownHeight;
	return open * (1.0 - crown.w * crown.z * crown.z / (crown.z * crown.z + high + 1.5 * away));
}
`;

/**
 * Height of the grass at a place, 0 … 1, and the march of the line of sight through it: from where the line is
 * `GRASS` metres over the ground in steps down to the ground (parallax occlusion mapping, Tatarchuk 2006). The place
 * that is seen is nearer than where the line meets the ground, so that blades stand up at grazing angles.
 */
const GRASS_CHUNK = /* glsl */ `
float flat_noise(vec2 at) {
	vec2 floored = floor(at);
	vec2 f = at - floored;
	f = f * f * (3.0 - 2.0 * f);
	uvec2 low = uvec2(ivec2(floored)) * NOISE_PRIMES.xy;
	uvec2 high = low + NOISE_PRIMES.xy;
	uvec2 y = uvec2((low.y >> 7u) ^ (low.y << 9u), (high.y >> 7u) ^ (high.y << 9u));
	vec4 corners = mixed_bits(uvec4(low.x ^ y.x, high.x ^ y.x, low.x ^ y.y, high.x ^ y.y));
	vec2 sides = mix(corners.xz, corners.yw, f.x);
	return mix(sides.x, sides.y, f.y);
}
float grass(vec2 at) {
	return 0.35 * flat_noise(2.3 * at) + 0.65 * flat_noise(17.0 * at);
}
// Metres from where the line of sight meets the ground back to where it meets the grass; y is how deep that is, 0 … 1.
vec2 seen_grass(vec2 at, vec2 back, float slope) {
	float span = ${float(GRASS)} / max(slope, 0.02);
	float along = 1.0;
	float depth = 0.0;
	for (int i = 0; i < ${GRASS_STEPS}; i++) {
		float high = grass(at + back * span * along);
		depth = 1.0 - along;
		if (high > along) break;
		along -= ${float(1 / GRASS_STEPS)};
	}
	return vec2(span * max(along, 0.0), depth);
}
`;

const SURFACE = /* glsl */ `
#include <color_fragment>
vec2 metres = onGround;
// Detail finer than a pixel is left out, so that it does not flicker.
float pixel = length(toEye) * pixelAngle;
float deep = 0.5;
float grassy = outdoors * (1.0 - smoothstep(0.035, 0.11, pixel));
if (grassy > 0.0) {
	vec3 sight = cameraPosition - vec3(onGround.x, groundLevel, onGround.y);
	vec2 seen = seen_grass(metres, normalize(sight.xz), sight.y / length(sight.xz));
	metres += normalize(sight.xz) * seen.x;
	deep = mix(0.5, seen.y, grassy);
}
diffuseColor.rgb = mix(diffuseColor.rgb, ownGround, hasOwn * (1.0 - smoothstep(crown.z, 2.5 * crown.z, distance(metres, crown.xy))));
float broad = flat_noise(0.19 * metres);
float tufts = flat_noise(1.3 * metres);
float fine = flat_noise(38.0 * metres);
float light_ = 1.0 + 0.12 * (broad - 0.5) + 0.10 * (tufts - 0.5) + 0.9 * (0.5 - deep) + 0.22 * (fine - 0.5) * (1.0 - smoothstep(0.005, 0.03, pixel));
diffuseColor.rgb *= max(0.15, light_) * mix(vec3(1.10, 1.01, 0.84), vec3(0.92, 1.0, 0.94), 0.6 * broad + 0.4 * tufts);
// Bare, trodden soil with litter close to the stems.
float bare = 1.0 - smoothstep(0.0, 1.0, (distance(metres, crown.xy) - bareRadius * (0.75 + 0.7 * tufts)) / max(0.6 * bareRadius, 1e-3));
diffuseColor.rgb = mix(diffuseColor.rgb, soil * (0.75 + 0.3 * tufts + 0.4 * fine), 0.7 * bare);
`;

const OPENED = /* glsl */ `
float open_ = ground_open(metres);
reflectedLight.indirectDiffuse *= open_;
// Beside a stem, light that the sun's disc and the bright sky about it send is hidden as well.
reflectedLight.directDiffuse *= mix(1.0, open_, 0.35);
vec3 totalDiffuse =`;

const FADED = /* glsl */ `
#include <dithering_fragment>
if (outdoors > 0.0) {
	float away = length(toEye);
	float haze = 1.0 - exp(-away / ${float(HAZE / Math.LN2)});
	gl_FragColor.rgb = mix(gl_FragColor.rgb, hazeColour, max(haze * 0.9, smoothstep(0.55, 1.0, distance(metres, crown.xy) / radius)));
} else {
	float share = distance(metres, crown.xy) / radius;
	float ragged = 0.5 * flat_noise(14.0 / radius * metres) + 0.5 * flat_noise(47.0 / radius * metres);
	gl_FragColor.a = 1.0 - smoothstep(${float(PATCH_INNER)}, 1.0, share + 0.22 * (ragged - 0.5) * smoothstep(0.1, 0.6, share));
}
`;

/** Ground of one plant at a time: a patch of grass or a meadow. */
export class Meadow {
	readonly mesh: Mesh<BufferGeometry, MeshStandardMaterial>;
	readonly #uniforms = {
		/** x, z and radius of the stems; radius 0 for none. */
		stems: { value: Array.from({ length: MAX_STEMS }, () => new Vector3()) },
		/** x and z of the crown, its radius, and the share of the sky that it hides. */
		crown: { value: new Vector4(0, 0, 1, 0) },
		crownHeight: { value: 1 },
		bareRadius: { value: 0 },
		/** Colour of the ground up to the crown's radius, if the plants bring ground of their own; `hasOwn` is then 1. */
		ownGround: { value: new Vector3() },
		hasOwn: { value: 0 },
		radius: { value: 1 },
		outdoors: { value: 0 },
		groundLevel: { value: 0 },
		/** Angle of a pixel, radians. */
		pixelAngle: { value: 1e-3 },
		hazeColour: { value: new Vector3() },
		soil: { value: new Vector3(...linear("5f513b")) },
	};
	#footing: Footing | undefined;
	#patch = PATCH;

	constructor(light: LightUniforms) {
		this.mesh = new Mesh(discGeometry(), groundMaterial(light, this.#uniforms));
		this.mesh.name = "ground";
		this.mesh.receiveShadow = true;
		this.mesh.frustumCulled = false;
		this.mesh.visible = false;
		// After the background: its rim is transparent.
		this.mesh.renderOrder = 3;
	}

	/** Height of the ground, metres; undefined without a plant. */
	get level(): number | undefined {
		return this.#footing?.centre[1];
	}

	/**
	 * Places the ground under a plant; undefined hides it.
	 * @param own colour of ground that the plants bring, which the meadow continues outdoors
	 */
	show(footing: Footing | undefined, own?: Colour): void {
		this.#footing = footing;
		if (!footing) {
			this.mesh.visible = false;
			return;
		}
		const { centre, stems, reach, height, cover } = footing;
		this.#uniforms.hasOwn.value = own ? 1 : 0;
		if (own) this.#uniforms.ownGround.value.fromArray(own);
		this.#uniforms.stems.value.forEach((to, i) => {
			to.set(stems[i]?.x ?? 0, stems[i]?.z ?? 0, stems[i]?.radius ?? 0);
		});
		this.#uniforms.crown.value.set(centre[0], centre[2], reach, cover);
		this.#uniforms.crownHeight.value = CROWN_HEIGHT * height;
		this.#uniforms.bareRadius.value = 3 * Math.max(0, ...stems.map(({ radius }) => radius));
		this.#uniforms.groundLevel.value = centre[1];
		this.mesh.position.set(centre[0], centre[1] - SINK * height, centre[2]);
	}

	/** Sets the meadow up to the horizon, with its colours; undefined sets the patch on the paper. */
	setOutdoors(look: { grass: string; haze: string } | undefined): void {
		const { outdoors, hazeColour } = this.#uniforms;
		outdoors.value = look ? 1 : 0;
		this.#patch = look ? linear(look.grass) : PATCH;
		this.mesh.material.color.setRGB(...this.#patch);
		this.mesh.material.transparent = !look;
		if (look) hazeColour.value.fromArray(encodedOf(look.haze));
	}

	/** Sizes the ground for a camera. @param visible whether there is ground at all: not in cut-out pictures */
	aim(camera: PerspectiveCamera, visible: boolean): void {
		const footing = this.#footing;
		this.mesh.visible = visible && footing !== undefined;
		if (!footing) return;
		const { outdoors, radius } = this.#uniforms;
		radius.value =
			outdoors.value > 0 ? MEADOW * camera.far : Math.max(PATCH_REACH * footing.reach, PATCH_HEIGHT * footing.height);
		this.mesh.scale.setScalar(radius.value);
		this.#uniforms.pixelAngle.value = (camera.fov * Math.PI) / 180 / PIXELS;
	}

	/** Releases the graphics memory. */
	dispose(): void {
		this.mesh.removeFromParent();
		this.mesh.geometry.dispose();
		this.mesh.material.dispose();
	}
}

/** Returns the sRGB channels of a hexadecimal colour, 0 … 1. */
function encodedOf(hex: string): [number, number, number] {
	return [0, 2, 4].map((at) => Number.parseInt(hex.slice(at, at + 2), 16) / 255) as [number, number, number];
}

/** Returns a flat disc of radius 1 in the plane y = 0, facing up; its rings are denser near the middle. */
function discGeometry(): BufferGeometry {
	const rings = [0.02, 0.08, 0.25, 1];
	const positions = [0, 0, 0];
	for (const ring of rings)
		for (let i = 0; i < ROUND; i++) {
			const angle = (2 * Math.PI * i) / ROUND;
			positions.push(ring * Math.cos(angle), 0, ring * Math.sin(angle));
		}
	const indices: number[] = [];
	for (let i = 0; i < ROUND; i++) {
		const next = (i + 1) % ROUND;
		indices.push(0, 1 + next, 1 + i);
		for (let ring = 0; ring + 1 < rings.length; ring++) {
			const [a, b, c, d] = [i, next, i + ROUND, next + ROUND].map((at) => 1 + ring * ROUND + at);
			indices.push(a, b, c, b, d, c);
		}
	}
	const geometry = new BufferGeometry();
	const count = positions.length / 3;
	geometry.setAttribute("position", new BufferAttribute(Float32Array.from(positions), 3));
	const normals = Float32Array.from({ length: 3 * count }, (_, i) => (i % 3 === 1 ? 1 : 0));
	geometry.setAttribute("normal", new BufferAttribute(normals, 3));
	geometry.setIndex(indices);
	return geometry;
}

/** Returns the material of the ground, with the shading of `Meadow`. */
function groundMaterial(light: LightUniforms, uniforms: Record<string, { value: unknown }>): MeshStandardMaterial {
	const made = standardMaterial({ name: "Ground", colour: PATCH, roughness: 1, specular: 0 }, { light });
	const lit = made.onBeforeCompile.bind(made);
	const key = made.customProgramCacheKey();
	made.transparent = true;
	made.depthWrite = true;
	made.onBeforeCompile = (shader, renderer) => {
		lit(shader, renderer);
		addGround(shader, uniforms);
	};
	made.customProgramCacheKey = () => `${key} standing ground`;
	return made;
}

/** Extends the program of a lit material by the ground's pattern, its darkening and its fading. */
function addGround(shader: WebGLProgramParametersWithUniforms, uniforms: Record<string, { value: unknown }>): void {
	Object.assign(shader.uniforms, uniforms);
	const varyings = "varying vec2 onGround;\nvarying vec3 toEye;";
	shader.vertexShader = shader.vertexShader
		.replace("#include <common>", `#include <common>\n${varyings}`)
		.replace(
			"#include <project_vertex>",
			"#include <project_vertex>\nonGround = (modelMatrix * vec4(transformed, 1.0)).xz;\ntoEye = mvPosition.xyz;",
		);
	shader.fragmentShader = shader.fragmentShader
		.replace(
			"#include <common>",
			`#include <common>
${varyings}
uniform vec3 stems[${MAX_STEMS}];
uniform vec4 crown;
uniform float crownHeight;
uniform float bareRadius;
uniform vec3 ownGround;
uniform float hasOwn;
uniform float radius;
uniform float outdoors;
uniform vec3 hazeColour;
uniform vec3 soil;
uniform float groundLevel;
uniform float pixelAngle;
${NOISE_CHUNK}
${GRASS_CHUNK}
${OPEN}`,
		)
		.replace("#include <color_fragment>", SURFACE)
		.replace("vec3 totalDiffuse =", OPENED)
		.replace("#include <dithering_fragment>", FADED);
}
