import { DoubleSide, ShaderMaterial, Vector3 } from "three";
import { float } from "../../../scene/glsl";
import { LIGHT_CHUNK } from "../../../scene/light_shader";
import { ANTHER_V, STAMEN } from "../parts/foliage_colour";
import { RECORD_CHUNK, SHADE_CHUNK, type SharedUniforms } from "./occlusion_shader";

/** Flowers look up fewer spheres than berries do. */
const NEIGHBOURS_OF_FLOWER = 5;

/** `bloomed` is the berry and how far its stamens stand out. They are finer than a pixel: lit per vertex. */
const VERTEX = /* glsl */ `
attribute vec2 bloomed;
uniform vec3 filament;
uniform vec3 anther;
varying vec3 colour;
${RECORD_CHUNK}
${LIGHT_CHUNK}
${SHADE_CHUNK}
void main() {
	int berry = int(bloomed.x);
	vec4 centre = receiver_texel(berry, 0);
	vec3 up = receiver_texel(berry, 1).xyz;
	vec4 form = receiver_texel(berry, 4);
	vec3 east = normalize(cross(up, vec3(0.31, 0.17, 0.93)));
	mat3 turn = mat3(east, up, cross(east, up));
	vec3 point = turn * (position * form.x * bloomed.y);
	vec3 n = turn * normal;
	vec3 skin = mix(filament, anther, step(${float(ANTHER_V)}, uv.y));
	Nearby around = nearby(berry, ${NEIGHBOURS_OF_FLOWER}, point, n, n, n, 0.5);
	// Thin and pale, they let half the light through.
	float nk = 0.35 + 0.65 * abs(dot(n, keyDirection));
	vec3 light = key.irradiance * (0.3183 * nk * key_light(berry, point)) + rim.irradiance * (0.12 * caster_texel(berry, 0).y);
	colour = skin * (light + diffuse_surroundings(mat3(viewMatrix) * n) * bounced(around.sky, skin));
	gl_Position = projectionMatrix * viewMatrix * vec4(centre.xyz + point, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
varying vec3 colour;
void main() {
	gl_FragColor = vec4(colour, 1.0);
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}
`;

/** The one material of all stamens. */
export function flowerMaterial(shared: SharedUniforms): ShaderMaterial {
	return new ShaderMaterial({
		name: "flower",
		vertexShader: VERTEX,
		fragmentShader: FRAGMENT,
		uniforms: {
			...shared,
			filament: { value: new Vector3(...STAMEN.filament) },
			anther: { value: new Vector3(...STAMEN.anther) },
		},
		side: DoubleSide,
	});
}
