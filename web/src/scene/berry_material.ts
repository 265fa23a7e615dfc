import { ShaderMaterial, Vector3 } from "three";
import { LIGHT_CHUNK, type LightUniforms, RECORD_CHUNK } from "./light_shader";
import type { Skin } from "./skin";

const VERTEX = /* glsl */ `
attribute float receiver;
flat varying int berry;
varying vec3 point;
varying vec3 facing;
varying vec3 body;
${RECORD_CHUNK}
void main() {
	berry = int(receiver);
	vec4 sphere = receiver_texel(berry, 0);
	vec4 pose = receiver_texel(berry, 1);
	// A frame whose +Y is the berry's direction, spun by its phase so that no two show the same face.
	vec3 y = normalize(pose.xyz);
	vec3 side = abs(y.x) < 0.8 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0);
	vec3 x = normalize(cross(y, side));
	vec3 z = cross(x, y);
	float spin = 6.2832 * pose.w;
	mat3 frame = mat3(cos(spin) * x + sin(spin) * z, y, cos(spin) * z - sin(spin) * x);
	body = position;
	facing = frame * normal;
	point = frame * position * sphere.w;
	gl_Position = projectionMatrix * viewMatrix * vec4(sphere.xyz + point, 1.0);
}
`;

/** The skin, the flesh behind it and the wax on it. */
const FRAGMENT = /* glsl */ `
flat varying int berry;
varying vec3 point;
varying vec3 facing;
varying vec3 body;
uniform vec3 absorption;
uniform vec3 wax;
uniform vec3 scar;
uniform float translucency;
uniform float bloom;
uniform float rind;
${RECORD_CHUNK}
${LIGHT_CHUNK}

// What is left of light that entered on the far side: its path through the ball is a chord.
vec3 through(float chord) {
	return exp(-absorption * chord);
}

void main() {
	vec4 sphere = receiver_texel(berry, 0);
	vec4 tint = receiver_texel(berry, 2);
	float phase = receiver_texel(berry, 1).w;
	vec2 lamps = caster_texel(berry, 0).xy;
	vec3 n = normalize(facing);
	vec3 v = normalize(cameraPosition - sphere.xyz - point);
	float nv = clamp(dot(n, v), 0.0, 1.0);
	float coarse = noise(body * 1.7 + phase * 61.0);
	float fine = noise(body * 9.0 + phase * 23.0);

	// Where wax lies: all over, thinner below, patchy, rubbed off where berries touch.
	vec3 r = reflect(-v, n);
	float dull = mix(0.07, 0.5, rind);
	Nearby around = nearby(berry, point, n, r, 0.12 + dull);
	float rubbed = smoothstep(0.0, 0.2 + 0.2 * fine, around.gap / sphere.w);
	float patches = smoothstep(0.18, 0.75, 0.75 * coarse + 0.35 * fine);
	float depth = 1.5 * bloom * tint.w * rubbed * mix(0.3, 1.0, patches) * (0.55 + 0.45 * n.y);
	float waxed = 1.0 - exp(-depth / (0.25 + nv));

	// The marks of pedicel and style.
	float along = body.y / length(body);
	float marked = smoothstep(0.982, 0.992, along + 0.006 * (fine - 0.5));
	float halo = smoothstep(0.9, 0.985, along) * (1.0 - marked);
	float seat = smoothstep(-0.9, -0.985, along);
	vec3 skin = tint.rgb * (0.86 + 0.28 * coarse) * (0.94 + 0.12 * fine);
	skin = mix(skin, skin * 1.25 + 0.02, 0.5 * halo + 0.4 * seat);
	skin = mix(skin, skin * (0.55 + 0.75 * fine), rind);
	skin = mix(skin, scar, marked * 0.9);

	// Light on the skin.
	float lit = key_light(berry, point);
	float nk = dot(n, keyDirection);
	float nb = dot(n, rimDirection);
	vec3 soft = translucency * (0.25 + 0.35 * sqrt(skin));
	vec3 dN = mat3(viewMatrix) * n;
	vec3 sky = surroundings(dN, lobesDiffuse);
	vec3 keyed = key.irradiance * (lit / 3.14159);
	vec3 rimmed = rim.irradiance * (lamps.y / 3.14159);
	vec3 white = keyed * clamp((nk + 0.1) / 1.1, 0.0, 1.0) + rimmed * clamp((nb + 0.1) / 1.1, 0.0, 1.0);
	vec3 wrapped = keyed * clamp((nk + soft) / (1.0 + soft), 0.0, 1.0) + rimmed * clamp((nb + soft) / (1.0 + soft), 0.0, 1.0);
	vec3 colour = skin * (wrapped + sky * bounced(around.sky, skin));

	// Light through the flesh: what the lamps send in on the other side, gathered towards the far pole, and what
	// stands behind the berry, seen through it.
	float farKey = clamp(-nk, 0.0, 1.0);
	float farRim = clamp(-nb, 0.0, 1.0);
	float gathered = 0.25 + 1.6 * farKey * farKey * farKey;
	vec3 glow = key.irradiance * lamps.x * (gathered * smoothstep(-0.25, 0.35, -nk)) * through(2.0 * farKey);
	glow += rim.irradiance * lamps.y * smoothstep(-0.3, 0.3, -nb) * 0.8 * through(2.0 * farRim);
	vec3 bent = refract(-v, n, 0.73);
	vec3 behind = surroundings(mat3(viewMatrix) * bent, lobesGloss) * through(-2.0 * dot(bent, n));
	colour = mix(colour, colour * 0.45, translucency * 0.6) + translucency * (0.3183 * glow * mix(0.35, 1.0, around.sky) + behind * mix(0.12, 0.55, around.sky));
	colour = mix(colour, wax * (white + sky * around.sky), waxed);

	// The mirror of the skin.
	float fresnel = 0.035 + 0.965 * pow(1.0 - nv, 5.0);
	float taut = (1.0 - 0.8 * waxed) * (1.0 - 0.75 * rind) * (1.0 - marked);
	vec3 dR = mat3(viewMatrix) * r;
	float blur = dull + 0.3 * waxed;
	vec3 mirror = key.radiance * (reflected_window(dR, key, blur) * lit) + rim.radiance * (reflected_window(dR, rim, 0.15 + blur) * lamps.y);
	mirror += surroundings(dR, lobesGloss) * mix(0.15 * skin, vec3(1.0), around.mirror);
	colour += mirror * fresnel * taut;

	gl_FragColor = vec4(colour, 1.0);
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}
`;

/** The one material of all berries. */
export function berryMaterial(shared: LightUniforms & Record<string, { value: unknown }>): ShaderMaterial {
	return new ShaderMaterial({
		name: "berry",
		vertexShader: VERTEX,
		fragmentShader: FRAGMENT,
		uniforms: {
			...shared,
			absorption: { value: new Vector3() },
			wax: { value: new Vector3() },
			scar: { value: new Vector3(0.09, 0.05, 0.028) },
			translucency: { value: 0 },
			bloom: { value: 0 },
			rind: { value: 0 },
		},
	});
}

/** Dresses the berries in a skin. */
export function setSkin(material: ShaderMaterial, skin: Skin): void {
	const { uniforms } = material;
	uniforms.absorption.value.fromArray(skin.absorption);
	uniforms.wax.value.fromArray(skin.wax);
	uniforms.translucency.value = skin.translucency;
	uniforms.bloom.value = skin.bloom;
	uniforms.rind.value = skin.roughness;
}
