import { NOISE_CHUNK } from "../plant/noise";
import { float } from "./glsl";

/**
 * Furrows along what a chart goes round, for `standardMaterial`'s `detail`: u once round, v as long as that is (geometry/tubes.hpp).
 * Where they are too small to be seen they fade.
 * @param depth how much darker the ground of a furrow is, 0 … 1
 */
export function grainChunk(depth: number): string {
	return `${NOISE_CHUNK}
float furrows(vec2 chart, float round, float stretch) {
	float turn = 6.2831853 * chart.x;
	vec3 at = vec3(vec2(cos(turn), sin(turn)) * round / 6.2831853, chart.y * round / stretch);
	float seen = clamp(0.7 / max(1e-4, length(fwidth(at))), 0.0, 1.0);
	return mix(0.5, 1.0 - abs(2.0 * noise(at) - 1.0), seen * seen);
}
vec3 detailed(vec3 colour, vec2 chart) {
	float ridge = 0.6 * furrows(chart, 26.0, 4.0) + 0.4 * furrows(chart + 0.37, 70.0, 3.0);
	return colour * (1.0 + ${float(depth)} * (1.6 * ridge - 1.0));
}
`;
}
