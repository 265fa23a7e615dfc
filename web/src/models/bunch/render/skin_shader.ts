import { float } from "../../../render/glsl";
import { FURROWS } from "../parts/skin_rules";

/**
 * Shader functions for the skin's own properties at a point, without light. `at` is the point in berry space (the
 * berry scaled to the unit ball), `chart` its u and v.
 */
export const SKIN_CHUNK = /* glsl */ `
uniform float rind;
uniform float lenticels;
uniform float veins;

// The normal of a rind with low bumps: uphill is where the noise grows.
vec3 rough(vec3 n, vec3 at, float height) {
	vec3 slope = vec3(0.0);
	for (int i = 0; i < 4; i++) {
		vec3 step = ${float(FURROWS.step)} * vec3(i == 1, i == 2, i == 3);
		slope += noise(at + step) * (i == 0 ? vec3(-1.0) : vec3(i == 1, i == 2, i == 3));
	}
	return normalize(n - height * (slope - n * dot(n, slope)));
}

// Small corky dots; they fade when smaller than a pixel.
float lenticel(vec3 at, float phase) {
	vec3 place = at * 11.0 + phase * 37.0;
	vec3 cell = floor(place);
	uvec3 c = uvec3(ivec3(cell)) * NOISE_PRIMES;
	vec4 chance = mixed_bits((c.x ^ (c.y >> 7u) ^ (c.z << 5u)) + uvec4(0u, 0x68bc21ebu, 0x02e5be93u, 0x967a889bu));
	vec3 middle = 0.5 + 0.24 * (chance.xyz - 0.5);
	float pixel = length(fwidth(at)) * 11.0;
	float size = 0.1 + 0.08 * chance.x;
	float away = length(place - cell - middle);
	return step(0.45, chance.w) * (1.0 - smoothstep(size - 0.5 * pixel, size + 0.5 * pixel + 0.05, away)) * clamp(0.5 / pixel, 0.0, 1.0);
}

// Veins that run from the seat to the tip just under the skin.
float vein(vec2 chart, float fine) {
	float at = abs(fract(chart.x * 12.0 + 0.35 * (fine - 0.5)) - 0.5);
	return (1.0 - smoothstep(0.03, 0.16, at)) * smoothstep(0.04, 0.2, chart.y) * smoothstep(0.99, 0.85, chart.y);
}
`;
