import { Matrix3, type Matrix4, Vector3, Vector4 } from "three";
import { CAST_RECORD, CASTERS } from "./casters";
import {
	blurred,
	COSINE_SHARPNESS,
	frameOf,
	GLOSS_SHARPNESS,
	type LightRig,
	type Lobe,
	spreadOf,
	type Window,
} from "./light";
import { FAR, RECORD } from "./receivers";
import { RECORDS_PER_ROW } from "./record_texture";

const LOBES = 4;

const sum = (set: string) =>
	Array.from({ length: LOBES }, (_, i) => `lobe(d, ${set}Lobes[${i}]) * ${set}Colours[${i}]`).join(" + ");

/** Uniform values of one window. */
function windowUniforms(): {
	toFrame: Matrix3;
	extent: Vector3;
	irradiance: Vector3;
	radiance: Vector3;
	spread: number;
} {
	return {
		toFrame: new Matrix3(),
		extent: new Vector3(),
		irradiance: new Vector3(),
		radiance: new Vector3(),
		spread: 0,
	};
}

/** The uniforms every lit surface shares: one object, so that a change of light reaches all materials at once. */
export function lightUniforms() {
	const lobes = () => Array.from({ length: LOBES }, () => new Vector4());
	const colours = () => Array.from({ length: LOBES }, () => new Vector3());
	return {
		diffuseLobes: { value: lobes() },
		diffuseColours: { value: colours() },
		glossLobes: { value: lobes() },
		glossColours: { value: colours() },
		key: { value: windowUniforms() },
		rim: { value: windowUniforms() },
		keyDirection: { value: new Vector3() },
		rimDirection: { value: new Vector3() },
	};
}

export type LightUniforms = ReturnType<typeof lightUniforms>;

/** What every material of the scene is made with: the light, and what else they share. */
export type SharedUniforms = LightUniforms & Record<string, { value: unknown }>;

function setWindow(to: ReturnType<typeof windowUniforms>, window: Window): void {
	to.toFrame.copy(frameOf(window));
	to.extent.set(window.half[0], window.half[1], window.bars);
	to.irradiance.fromArray(window.irradiance);
	// Brighter than its irradiance alone would make it, for the highlight that film rolls off and a screen clips.
	to.radiance.copy(to.irradiance).multiplyScalar(1.6 / (4 * window.half[0] * window.half[1]));
	to.spread = spreadOf(window);
}

/** exp(s (cos γ − 1)) as (1 + s (cos γ − 1) / 8)⁸, which a GPU without fast exponentials draws in half the time. */
function setLobe(lobe: Vector4, colour: Vector3, { axis, sharpness, colour: rgb }: Lobe): void {
	const scale = sharpness / 8;
	lobe.set(axis.x * scale, axis.y * scale, axis.z * scale, 1 - scale);
	colour.fromArray(rgb);
}

/** Loads a rig into the uniforms. */
export function setRig(uniforms: LightUniforms, rig: LightRig): void {
	rig.surroundings.forEach((lobe, i) => {
		setLobe(uniforms.diffuseLobes.value[i], uniforms.diffuseColours.value[i], blurred(lobe, COSINE_SHARPNESS));
		setLobe(uniforms.glossLobes.value[i], uniforms.glossColours.value[i], blurred(lobe, GLOSS_SHARPNESS));
	});
	setWindow(uniforms.key.value, rig.key);
	setWindow(uniforms.rim.value, rig.rim);
}

/** Turns the lamps with the viewer: the bunch is turned in the light, the light is not walked around. */
export function aimLamps(uniforms: LightUniforms, rig: LightRig, cameraWorld: Matrix4): void {
	uniforms.keyDirection.value.copy(rig.key.direction).transformDirection(cameraWorld);
	uniforms.rimDirection.value.copy(rig.rim.direction).transformDirection(cameraWorld);
}

/** Fetching records; for vertex and fragment shaders. */
export const RECORD_CHUNK = /* glsl */ `
uniform highp sampler2D receiverRecords;
uniform highp sampler2D casterRecords;
vec4 receiver_texel(int receiver, int texel) {
	return texelFetch(receiverRecords, ivec2((receiver % ${RECORDS_PER_ROW}) * ${RECORD} + texel, receiver / ${RECORDS_PER_ROW}), 0);
}
vec4 caster_texel(int receiver, int texel) {
	return texelFetch(casterRecords, ivec2((receiver % ${RECORDS_PER_ROW}) * ${CAST_RECORD} + texel, receiver / ${RECORDS_PER_ROW}), 0);
}
`;

/**
 * Light arriving at a point. Directions \`n\`, \`r\`, \`v\` are the bunch's own; the surroundings and windows are the
 * viewer's, reached through viewMatrix. \`p\` is the point relative to its receiver's centre.
 */
export const LIGHT_CHUNK = /* glsl */ `
struct Window { mat3 toFrame; vec3 extent; vec3 irradiance; vec3 radiance; float spread; };
struct Nearby { float sky; float mirror; float through; };
uniform vec4 diffuseLobes[${LOBES}];
uniform vec3 diffuseColours[${LOBES}];
uniform vec4 glossLobes[${LOBES}];
uniform vec3 glossColours[${LOBES}];
uniform Window key;
uniform Window rim;
uniform vec3 keyDirection;
uniform vec3 rimDirection;
uniform float berriesShown;

float lobe(vec3 d, vec4 at) {
	float x = max(0.0, dot(d, at.xyz) + at.w);
	x *= x;
	x *= x;
	return x * x;
}

// Light from all around: gathered over the half space about \`d\`, and mirrored from \`d\`.
vec3 diffuse_surroundings(vec3 d) {
	return ${sum("diffuse")};
}
vec3 gloss_surroundings(vec3 d) {
	return ${sum("gloss")};
}

// Share of a mirror lobe that falls into the window; \`blur\` is the tangent by which roughness softens its edges.
float reflected_window(vec3 d, Window w, float blur) {
	vec3 q = w.toFrame * d;
	if (q.z <= 0.05) return 0.0;
	vec2 at = q.xy / q.z;
	vec2 inside = smoothstep(-w.extent.xy - blur, -w.extent.xy + blur, at) - smoothstep(w.extent.xy - blur, w.extent.xy + blur, at);
	float bar = w.extent.z / (w.extent.z + 0.6 * blur);
	vec2 pane = 1.0 - bar * (1.0 - smoothstep(w.extent.z, w.extent.z + blur, abs(at - vec2(0.0, 0.3 * w.extent.y))));
	vec2 kept = w.extent.xy / (w.extent.xy + 0.5 * blur);
	return inside.x * inside.y * kept.x * kept.y * (w.extent.z > 0.0 ? pane.x * pane.y : 1.0);
}

float sky_hidden(float sine, float cosine) {
	float low = cosine + sine;
	float lifted = cosine >= sine ? cosine : low * low / (4.0 * sine);
	return low <= 0.0 ? 0.0 : sine * sine * lifted;
}

// What the nearest spheres and the far ones leave of the sky, of the mirror lobe and of what is seen through the flesh
// along \`bent\`.
Nearby nearby(int receiver, int neighbours, vec3 p, vec3 n, vec3 r, vec3 bent, float blur) {
	Nearby result = Nearby(1.0, 1.0, 1.0);
	if (berriesShown < 0.5) return result;
	vec4 far = receiver_texel(receiver, ${FAR});
	result.sky = exp(-max(0.0, far.x + dot(far.yzw, n)));
	result.mirror = exp(-max(0.0, far.x + dot(far.yzw, r)));
	result.through = exp(-2.0 * max(0.0, far.x + dot(far.yzw, bent)));
	for (int i = 0; i < neighbours; i++) {
		vec4 s = receiver_texel(receiver, ${FAR + 1} + i);
		if (s.w <= 0.0) break;
		vec3 d = s.xyz - p;
		float away = max(length(d), s.w * 1.001);
		d /= away;
		float sine = s.w / away;
		result.sky *= 1.0 - sky_hidden(sine, dot(n, d));
		float edge = sqrt(1.0 - sine * sine);
		result.mirror *= 1.0 - smoothstep(edge - blur, edge + blur, dot(r, d));
		result.through *= 1.0 - smoothstep(edge - 0.35, edge + 0.35, dot(bent, d));
	}
	return result;
}

// Share of the key light that passes the spheres in its way.
float key_light(int receiver, vec3 p) {
	float share = 1.0;
	if (berriesShown < 0.5) return share;
	for (int i = 0; i < ${CASTERS}; i++) {
		vec4 s = caster_texel(receiver, 1 + i);
		if (s.w <= 0.0) break;
		vec3 d = s.xyz - p;
		float along = dot(d, keyDirection);
		float lateral = sqrt(max(0.0, dot(d, d) - along * along));
		float blur = max(along * key.spread, 0.02 * s.w);
		float most = min(1.0, s.w * s.w / (blur * blur));
		share *= 1.0 - most * (1.0 - smoothstep(s.w - blur, s.w + blur, lateral)) * step(0.0, along);
	}
	return share;
}

// Light that bounces between equal surfaces brightens and tints the shade (Jimenez et al. 2016, "Practical real-time
// strategies for accurate indirect occlusion", equation 10).
vec3 bounced(float visible, vec3 albedo) {
	vec3 a = 2.0404 * albedo - 0.3324;
	vec3 b = -4.7951 * albedo + 0.6417;
	vec3 c = 2.7552 * albedo + 0.6903;
	return max(vec3(visible), ((visible * a + b) * visible + c) * visible);
}
`;

/** Noise, for fragment shaders. */
export const NOISE_CHUNK = /* glsl */ `
float hash(ivec3 cell) {
	uvec3 c = uvec3(cell) * uvec3(0x9e3779b1u, 0x85ebca6bu, 0xc2b2ae35u);
	uint h = (c.x ^ (c.y >> 7u) ^ (c.y << 9u) ^ (c.z >> 13u) ^ (c.z << 3u)) * 0x27d4eb2du;
	h = (h ^ (h >> 15u)) * 0x2c1b3c6du;
	return float(h >> 16u) / 65535.0;
}

// Smooth noise of one octave, 0 … 1. A loop rather than eight lines: a shader's first compilation is paid by the eye.
float noise(vec3 at) {
	vec3 floored = floor(at);
	ivec3 cell = ivec3(floored);
	vec3 f = at - floored;
	f = f * f * (3.0 - 2.0 * f);
	float sum = 0.0;
	for (int i = 0; i < 4; i++) {
		ivec3 corner = cell + ivec3(0, i & 1, i >> 1);
		vec2 share = mix(1.0 - f.yz, f.yz, vec2(i & 1, i >> 1));
		sum += share.x * share.y * mix(hash(corner), hash(corner + ivec3(1, 0, 0)), f.x);
	}
	return sum;
}
`;
