import { DoubleSide, ShaderMaterial, Vector3 } from "three";
import { NOISE_CHUNK } from "../../../plant/noise";
import { step, vec3 } from "../../../scene/glsl";
import { LIGHT_CHUNK } from "../../../scene/light_shader";
import { AUTUMN, CANE, LEAF, PETIOLE } from "../parts/foliage_colour";
import type { SharedUniforms } from "./occlusion_shader";

const VERTEX = /* glsl */ `
attribute float blade;
varying vec3 place;
varying vec3 facing;
varying vec3 chart;
void main() {
	place = position;
	facing = normal;
	chart = vec3(uv, blade);
	gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}
`;

/** Leaves let light through, veins less of it; cane is bark with long cracks. */
const FRAGMENT = /* glsl */ `
varying vec3 place;
varying vec3 facing;
varying vec3 chart;
uniform vec3 upper;
uniform vec3 lower;
uniform vec3 cane;
uniform vec3 petiole;
uniform float autumn;
${LIGHT_CHUNK}
${NOISE_CHUNK}

// Five main veins fan out from the petiole at (1/2, 0); side veins leave them in pairs. 1 on a vein.
float veins(vec2 at) {
	vec2 from = vec2(abs(at.x - 0.5), at.y - 0.16);
	float away = length(from);
	float angle = atan(from.x, from.y);
	// 0°, 52° and 108° from the midrib, and the nearest of them.
	float nearest = angle < 0.46 ? 0.0 : angle < 1.4 ? 0.91 : 1.88;
	float off = (angle - nearest) * away;
	float main_ = 1.0 - smoothstep(0.004, 0.012 + 0.006 * (1.0 - away), abs(off));
	float run = away * 9.0 - abs(off) * 8.0;
	float side = 1.0 - smoothstep(0.03, 0.13, abs(fract(run) - 0.5));
	return max(main_, 0.45 * side * smoothstep(0.0, 0.05, abs(off)));
}

void main() {
	vec3 v = normalize(cameraPosition - place);
	vec3 n = normalize(facing) * (gl_FrontFacing ? 1.0 : -1.0);
	float mottle = noise(place * 260.0);
	float broad = noise(place * 45.0);
	float leaf = step(0.75, chart.z);
	vec3 skin;
	float vein = 0.0;
	float clear = 0.0;
	if (leaf > 0.5) {
		vein = veins(chart.xy);
		skin = mix(lower, upper, gl_FrontFacing ? 1.0 : 0.0) * (0.8 + 0.3 * broad + 0.15 * mottle);
		float turned = ${step(AUTUMN, "autumn * (0.6 + 0.5 * broad + 0.5 * length(chart.xy - vec2(0.5, 0.35)))")};
		skin = mix(skin, ${vec3(LEAF.late)} * (0.7 + 0.5 * mottle), turned * (1.0 - 0.5 * vein));
		skin = mix(skin, skin * 0.6 + vec3(0.12, 0.14, 0.05), 0.55 * vein);
		clear = 0.75 - 0.45 * vein;
		n = normalize(n + 0.25 * (broad - 0.5) * v);
	} else if (chart.z > 0.25) {
		skin = petiole * (0.85 + 0.3 * mottle);
	} else {
		float crack = noise(vec3(chart.x * 26.0, chart.y * 1.6, broad));
		skin = cane * (0.55 + 0.75 * crack) * (0.85 + 0.3 * mottle);
	}
	float nk = dot(n, keyDirection);
	float nb = dot(n, rimDirection);
	vec3 sky = diffuse_surroundings(mat3(viewMatrix) * n);
	vec3 light = (key.irradiance * max(nk, 0.0) + rim.irradiance * max(nb, 0.0)) / 3.14159 + sky;
	// What comes through a blade is its own colour twice over, yellower.
	vec3 through = (key.irradiance * max(-nk, 0.0) + rim.irradiance * max(-nb, 0.0)) / 3.14159 + 0.6 * diffuse_surroundings(mat3(viewMatrix) * -n);
	vec3 colour = skin * light + clear * sqrt(skin) * skin * vec3(1.1, 1.2, 0.6) * through;
	vec3 r = mat3(viewMatrix) * reflect(-v, n);
	float fresnel = 0.03 + 0.3 * pow(1.0 - clamp(dot(n, v), 0.0, 1.0), 5.0);
	float shine = leaf * (gl_FrontFacing ? 1.0 : 0.35) + 0.2 * (1.0 - leaf);
	colour += fresnel * shine * (key.radiance * reflected_window(r, key, 0.5) + gloss_surroundings(r));
	gl_FragColor = vec4(colour, 1.0);
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}
`;

/** The one material of leaves, petioles and cane. */
export function foliageMaterial(shared: SharedUniforms): ShaderMaterial {
	return new ShaderMaterial({
		name: "foliage",
		vertexShader: VERTEX,
		fragmentShader: FRAGMENT,
		uniforms: {
			...shared,
			upper: { value: new Vector3(...LEAF.upper) },
			lower: { value: new Vector3(...LEAF.lower) },
			cane: { value: new Vector3(...CANE) },
			petiole: { value: new Vector3(...PETIOLE) },
			autumn: { value: 0 },
		},
		side: DoubleSide,
	});
}
