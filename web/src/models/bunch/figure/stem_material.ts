import { ShaderMaterial, Vector3 } from "three";
import { linear } from "../../../plant/colour";
import { NOISE_CHUNK } from "../../../plant/noise";
import { float, step, vec3 } from "../../../scene/glsl";
import { LIGHT_CHUNK } from "../../../scene/light_shader";
import { BARK, BROWN, LATER, MOTTLES, SHADE, YOUNG } from "../parts/stem_rules";
import { RECORD_CHUNK, SHADE_CHUNK, type SharedUniforms } from "./occlusion_shader";

const { node, streak, withered, wood } = BROWN;

/** Stems look up fewer spheres than berries do: those that matter most. */
const NEIGHBOURS_OF_STEM = 6;

/**
 * Stems are thin and matt: light on them is worked out per vertex. Their triangles are often narrower than a pixel, and a
 * pixel is shaded once for each that touches it.
 */
const VERTEX = /* glsl */ `
attribute uint internode;
uniform int firstInternode;
uniform vec3 green;
uniform float marking;
varying vec3 light;
varying vec3 sheen;
varying vec3 bark;
varying vec3 state;
${RECORD_CHUNK}
${LIGHT_CHUNK}
${SHADE_CHUNK}
void main() {
	int receiver = firstInternode + int(internode);
	vec4 middle = receiver_texel(receiver, 0);
	vec4 axis = receiver_texel(receiver, 1);
	vec2 nature = receiver_texel(receiver, 2).xy;
	float withered = nature.x;
	vec3 point = position - middle.xyz;
	// How near the internode's ends, 0 in the middle, 1 at a node; and how early its kind turns to wood.
	state = vec3(withered, abs(dot(point, axis.xyz)) / max(dot(axis.xyz, axis.xyz), 1e-12), 1.0 - ${float(LATER)} * nature.y);
	bark = vec3(uv, position.y) * ${vec3(MOTTLES)};

	Nearby around = nearby(receiver, ${NEIGHBOURS_OF_STEM}, point, normal, normal, normal, 0.5);
	float lit = key_light(receiver, point);
	float open = berriesShown < 0.5 ? 1.0 : caster_texel(receiver, 0).y;
	float nk = clamp((dot(normal, keyDirection) + 0.2) / 1.2, 0.0, 1.0);
	float nb = clamp((dot(normal, rimDirection) + 0.2) / 1.2, 0.0, 1.0);
	light = (key.irradiance * (nk * lit) + rim.irradiance * (0.5 * nb * open)) / 3.14159;
	light += diffuse_surroundings(mat3(viewMatrix) * normal) * bounced(around.sky, green);
	// A faint sheen, as of fine down.
	vec3 v = normalize(cameraPosition - position);
	vec3 r = mat3(viewMatrix) * reflect(-v, normal);
	float fresnel = 0.02 + 0.28 * pow(1.0 - clamp(dot(normal, v), 0.0, 1.0), 5.0);
	sheen = fresnel * (key.radiance * (reflected_window(r, key, 0.55) * lit) + gloss_surroundings(r) * around.sky);

	// Marked pedicels are short and thin: swollen, they are seen.
	vec3 place = position + normal * (marking * withered * 0.6 * axis.w);
	gl_Position = projectionMatrix * viewMatrix * vec4(place, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
varying vec3 light;
varying vec3 sheen;
varying vec3 bark;
varying vec3 state;
uniform vec3 green;
uniform vec3 marked;
uniform float marking;
uniform float wood;
${NOISE_CHUNK}
void main() {
	float mottle = noise(bark);
	float withered = state.x;
	float node = ${step([node.from, 1], "state.y")} * ${float(node.share)};
	// Wood spreads from the nodes and along the bark's streaks, on the rachis first, on pedicels last.
	float aged = wood * state.z;
	float brown = node * mix(${float(node.young)}, 1.0, wood) + ${float(streak.share)} * ${step([streak.from, streak.to], "mottle")} * mix(${float(streak.young)}, 1.0, wood);
	brown = clamp(brown + ${float(withered)} * withered * (1.0 - marking) + ${float(wood.share)} * ${step([wood.from, wood.to], `aged + ${float(wood.mottle)} * mottle`)}, 0.0, 1.0);
	vec3 bark_ = green * mix(${vec3(BARK.first)}, ${vec3(BARK.last)}, aged) * mix(${float(BARK.light)}, ${float(BARK.dry)}, withered);
	vec3 young = mix(green * ${vec3(YOUNG.colour)}, green, min(1.0, ${float(YOUNG.until)} * wood));
	vec3 skin = mix(young, bark_, brown) * (${float(SHADE.least)} + ${float(SHADE.span)} * mottle);
	skin = mix(skin, marked, marking * withered);
	gl_FragColor = vec4(skin * light + sheen, 1.0);
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}
`;

/** The one material of all stems. */
export function stemMaterial(shared: SharedUniforms): ShaderMaterial {
	return new ShaderMaterial({
		name: "stem",
		vertexShader: VERTEX,
		fragmentShader: FRAGMENT,
		uniforms: {
			...shared,
			firstInternode: { value: 0 },
			green: { value: new Vector3() },
			marked: { value: new Vector3(...linear("c2334f")) },
			marking: { value: 0 },
			wood: { value: 0 },
		},
	});
}

/**
 * @param hex the look's stem colour
 * @param wood how far the stems have turned woody, 0 … 1
 */
export function setStem(material: ShaderMaterial, hex: string, wood: number): void {
	material.uniforms.green.value.fromArray(linear(hex));
	material.uniforms.wood.value = wood;
}
