import { ShaderMaterial, Vector3 } from "three";
import { fromHex } from "./colour";
import { LIGHT_CHUNK, type LightUniforms, RECORD_CHUNK } from "./light_shader";

/** Stems are thin: light on them is worked out per vertex, with the spheres that matter most. */
const NEIGHBOURS_OF_STEM = 6;

const VERTEX = /* glsl */ `
attribute uint internode;
uniform int firstInternode;
varying vec3 facing;
varying vec3 place;
varying vec2 bark;
varying vec3 state;
varying vec3 light;
${RECORD_CHUNK}
${LIGHT_CHUNK}
void main() {
	int receiver = firstInternode + int(internode);
	vec4 middle = receiver_texel(receiver, 0);
	vec4 axis = receiver_texel(receiver, 1);
	vec3 point = position - middle.xyz;
	place = position;
	facing = normal;
	bark = uv;
	// Withered or not, kind, and how near the internode's ends: 0 in the middle, 1 at a node.
	state = vec3(receiver_texel(receiver, 2).xy, abs(dot(point, axis.xyz)) / max(dot(axis.xyz, axis.xyz), 1e-12));
	Nearby around = nearby(receiver, ${NEIGHBOURS_OF_STEM}, point, normal, normal, normal, 0.5);
	float open = berriesShown < 0.5 ? 1.0 : caster_texel(receiver, 0).y;
	light = vec3(key_light(receiver, point), open, around.sky);
	gl_Position = projectionMatrix * viewMatrix * vec4(position, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
varying vec3 facing;
varying vec3 place;
varying vec2 bark;
varying vec3 state;
varying vec3 light;
uniform vec3 green;
uniform vec3 marked;
uniform float marking;
${RECORD_CHUNK}
${LIGHT_CHUNK}
void main() {
	vec3 n = normalize(facing);
	vec3 v = normalize(cameraPosition - place);
	float streak = noise(vec3(bark.x * 14.0, bark.y * 1.6, 3.0));
	float mottle = noise(place * 420.0);
	float withered = state.x;
	float node = smoothstep(0.72, 1.0, state.z) * 0.45;
	float brown = clamp(node + 0.5 * smoothstep(0.45, 0.85, 0.6 * mottle + 0.4 * streak) + 0.75 * withered * (1.0 - marking), 0.0, 1.0);
	vec3 wood = green * vec3(0.92, 0.62, 0.5) * mix(0.85, 0.5, withered);
	vec3 skin = mix(green, wood, brown) * (0.9 + 0.3 * streak + 0.2 * mottle);
	skin = mix(skin, marked, marking * withered);

	float nk = clamp((dot(n, keyDirection) + 0.2) / 1.2, 0.0, 1.0);
	float nb = clamp((dot(n, rimDirection) + 0.2) / 1.2, 0.0, 1.0);
	vec3 sky = diffuse_surroundings(mat3(viewMatrix) * n);
	vec3 white = (key.irradiance * nk * light.x + rim.irradiance * (0.5 * nb * light.y)) / 3.14159;
	vec3 colour = skin * (white + sky * bounced(light.z, skin));

	// A faint sheen, as of fine down.
	float nv = clamp(dot(n, v), 0.0, 1.0);
	float fresnel = 0.03 + 0.4 * pow(1.0 - nv, 5.0);
	vec3 dR = mat3(viewMatrix) * reflect(-v, n);
	vec3 mirror = key.radiance * reflected_window(dR, key, 0.55) * light.x + gloss_surroundings(dR) * light.z;
	colour += mirror * fresnel * 0.7;

	gl_FragColor = vec4(colour, 1.0);
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}
`;

/** The one material of all stems. */
export function stemMaterial(shared: LightUniforms & Record<string, { value: unknown }>): ShaderMaterial {
	return new ShaderMaterial({
		name: "stem",
		vertexShader: VERTEX,
		fragmentShader: FRAGMENT,
		uniforms: {
			...shared,
			firstInternode: { value: 0 },
			green: { value: new Vector3() },
			marked: { value: new Vector3(...fromHex("c2334f")) },
			marking: { value: 0 },
		},
	});
}

/** @param hex the look's stem colour */
export function setStem(material: ShaderMaterial, hex: string): void {
	material.uniforms.green.value.fromArray(fromHex(hex));
}
