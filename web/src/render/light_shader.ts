import { Matrix3, type Matrix4, Vector3, Vector4 } from "three";
import { BOUNCE } from "../plant/shade";
import { float } from "./glsl";
import {
	blurred,
	COSINE_SHARPNESS,
	frameOf,
	GLOSS_SHARPNESS,
	type LightRig,
	type Lobe,
	spreadOf,
	type WindowLight,
} from "./light";

const LOBES = 4;

/** Returns the GLSL sum of all lobes in direction `d`; `set` is the prefix of the uniforms, "diffuse" or "gloss". */
const sum = (set: string) =>
	Array.from({ length: LOBES }, (_, i) => `lobe(d, ${set}Lobes[${i}]) * ${set}Colours[${i}]`).join(" + ");

/** Returns empty uniform values of one window, which `setWindow` fills. */
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

/**
 * Returns the uniforms shared by all lit surfaces: one object, so that a change of light reaches all materials at
 * once.
 */
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

/** Fills a window's uniforms from the window of a rig. */
function setWindow(to: ReturnType<typeof windowUniforms>, window: WindowLight): void {
	to.toFrame.copy(frameOf(window));
	to.extent.set(window.half[0], window.half[1], window.bars);
	to.irradiance.fromArray(window.irradiance);
	// Brighter than by its irradiance alone: highlights that film compresses are clipped by a screen.
	to.radiance.copy(to.irradiance).multiplyScalar(1.6 / (4 * window.half[0] * window.half[1]));
	to.spread = spreadOf(window);
}

/**
 * Writes a lobe's uniforms. The shader computes exp(s (cos γ − 1)) as (1 + s (cos γ − 1) / 8)⁸, which a GPU without
 * fast exponentials draws in half the time: the vector holds axis · s / 8, and the constant 1 − s / 8.
 */
function setLobe(lobe: Vector4, colour: Vector3, { axis, sharpness, colour: rgb }: Lobe): void {
	const scale = sharpness / 8;
	lobe.set(axis.x * scale, axis.y * scale, axis.z * scale, 1 - scale);
	colour.fromArray(rgb);
}

/** Copies a rig into the uniforms. */
export function setRig(uniforms: LightUniforms, rig: LightRig): void {
	rig.surroundings.forEach((lobe, i) => {
		setLobe(uniforms.diffuseLobes.value[i], uniforms.diffuseColours.value[i], blurred(lobe, COSINE_SHARPNESS));
		setLobe(uniforms.glossLobes.value[i], uniforms.glossColours.value[i], blurred(lobe, GLOSS_SHARPNESS));
	});
	setWindow(uniforms.key.value, rig.key);
	setWindow(uniforms.rim.value, rig.rim);
}

/** Turns the lamps with the viewer, so that the plant turns in the light. */
export function aimLamps(uniforms: LightUniforms, rig: LightRig, cameraWorld: Matrix4): void {
	uniforms.keyDirection.value.copy(rig.key.direction).transformDirection(cameraWorld);
	uniforms.rimDirection.value.copy(rig.rim.direction).transformDirection(cameraWorld);
}

/** Light at a point. Directions are in view space, reached through viewMatrix, except those of the lamps. */
export const LIGHT_CHUNK = /* glsl */ `
struct WindowLight { mat3 toFrame; vec3 extent; vec3 irradiance; vec3 radiance; float spread; };
uniform vec4 diffuseLobes[${LOBES}];
uniform vec3 diffuseColours[${LOBES}];
uniform vec4 glossLobes[${LOBES}];
uniform vec3 glossColours[${LOBES}];
uniform WindowLight key;
uniform WindowLight rim;
uniform vec3 keyDirection;
uniform vec3 rimDirection;

float lobe(vec3 d, vec4 at) {
	float x = max(0.0, dot(d, at.xyz) + at.w);
	x *= x;
	x *= x;
	return x * x;
}

// Light of the surroundings: integrated over the half space about \`d\`, and reflected from \`d\`.
vec3 diffuse_surroundings(vec3 d) {
	return ${sum("diffuse")};
}
vec3 gloss_surroundings(vec3 d) {
	return ${sum("gloss")};
}

// Whether a direction can fall into a window, by its cosine to the middle and the tangents of the half angles: most of a
// plant reflects no window.
bool near_window(float cosine, vec2 tangents, float blur) {
	vec2 reach = tangents + blur;
	return cosine > inversesqrt(1.0 + dot(reach, reach));
}

vec2 eased(vec2 x) {
	x = clamp(x, 0.0, 1.0);
	return x * x * (3.0 - 2.0 * x);
}

// Share of a reflection lobe that falls into a window of an extent, \`q\` the direction in the window's frame; \`blur\` is
// the tangent by which roughness softens its edges.
float reflected_window(vec3 q, vec3 extent, float blur) {
	float share = 0.0;
	vec2 at = q.xy / max(q.z, 0.05);
	if (q.z > 0.05 && all(lessThan(abs(at), extent.xy + blur))) {
		float steep = 0.5 / blur;
		vec2 inside = eased((blur + extent.xy - abs(at)) * steep) - eased((blur - extent.xy - abs(at)) * steep);
		vec2 kept = extent.xy / (extent.xy + 0.5 * blur);
		share = inside.x * inside.y * kept.x * kept.y;
		if (extent.z > 0.0) {
			vec2 off = abs(at - vec2(0.0, 0.3 * extent.y)) - extent.z;
			vec2 pane = 1.0 - (1.0 - eased(off * (2.0 * steep))) * (extent.z / (extent.z + 0.6 * blur));
			share *= pane.x * pane.y;
		}
	}
	return share;
}

// The same as in plant/shade.ts, for colours.
vec3 bounced(float visible, vec3 albedo) {
${BOUNCE.map(([slope, offset], i) => `	vec3 ${"abc"[i]} = ${float(slope)} * albedo + ${float(offset)};`).join("\n")}
	return max(vec3(visible), ((visible * a + b) * visible + c) * visible);
}
`;
