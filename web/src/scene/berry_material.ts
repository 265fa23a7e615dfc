import { ShaderMaterial, Vector3 } from "three";
import { LIGHT_CHUNK, type LightUniforms, NOISE_CHUNK, RECORD_CHUNK } from "./light_shader";
import { NEIGHBOURS } from "./receivers";
import type { Skin } from "./skin";

/** Corners of the outline a berry is drawn with. */
const RIM = 32;

/**
 * A berry is a ball, so only the cap that faces the eye is drawn: `position` is (turn of azimuth, share of the way
 * from the cap's middle to its rim, 0), the rim is the ball's outline as the eye sees it. A fifth of the triangles of a
 * whole ball, and an outline that is round from every side.
 */
const VERTEX = /* glsl */ `
attribute float receiver;
flat varying int berry;
varying vec3 toPoint;
${RECORD_CHUNK}
void main() {
	berry = int(receiver);
	vec4 sphere = receiver_texel(berry, 0);
	vec3 toEye = cameraPosition - sphere.xyz;
	float away = max(length(toEye), 1.001 * sphere.w);
	vec3 w = toEye / away;
	vec3 u = normalize(cross(vec3(0.0, 1.0, 0.001), w));
	vec3 v = cross(w, u);
	float polar = position.y * acos(sphere.w / away);
	float azimuth = 6.2831853 * position.x;
	// The rim's chords lie as far outside the circle at their ends as inside it in their middle.
	float out_ = sin(polar) * (position.y < 1.0 ? 1.0 : ${(1 / Math.sqrt(Math.cos(Math.PI / RIM))).toFixed(6)});
	toPoint = sphere.w * (cos(polar) * w + out_ * (cos(azimuth) * u + sin(azimuth) * v)) - toEye;
	gl_Position = projectionMatrix * viewMatrix * vec4(cameraPosition + toPoint, 1.0);
}
`;

/** The skin, the flesh behind it and the wax on it. */
const FRAGMENT = /* glsl */ `
flat varying int berry;
varying vec3 toPoint;
uniform vec3 absorption;
uniform vec3 wax;
uniform vec3 scar;
uniform float translucency;
uniform float bloom;
uniform float rind;
${RECORD_CHUNK}
${LIGHT_CHUNK}
${NOISE_CHUNK}

// What is left of light that entered on the far side: its path through the ball is a chord.
vec3 through(float chord) {
	return exp(-absorption * chord);
}

// The normal of a rind with low bumps: uphill is where the noise grows.
vec3 rough(vec3 n, float phase, float height) {
	vec3 at = n * 13.0 + phase * 41.0;
	vec3 slope = vec3(0.0);
	for (int i = 0; i < 4; i++) {
		vec3 step = 0.3 * vec3(i == 1, i == 2, i == 3);
		slope += noise(at + step) * (i == 0 ? vec3(-1.0) : vec3(i == 1, i == 2, i == 3));
	}
	return normalize(n - height * (slope - n * dot(n, slope)));
}

void main() {
	vec4 sphere = receiver_texel(berry, 0);
	vec4 tint = receiver_texel(berry, 2);
	vec4 pose = receiver_texel(berry, 1);
	float phase = pose.w;
	vec2 lamps = caster_texel(berry, 0).xy;
	// Where the line of sight meets the ball itself.
	vec3 v = -normalize(toPoint);
	vec3 toEye = cameraPosition - sphere.xyz;
	float closest = dot(toEye, v);
	float depth2 = max(0.0, closest * closest - dot(toEye, toEye) + sphere.w * sphere.w);
	vec3 point = toEye - (closest - sqrt(depth2)) * v;
	vec3 n = normalize(point);
	vec3 round = n;
	float nv = clamp(dot(n, v), 0.0, 1.0);
	float coarse = noise(round * 1.7 + phase * 61.0);
	float fine = noise(round * 9.0 + phase * 23.0);

	// Where wax lies: all over, thinner below, patchy, rubbed off where berries touch.
	if (rind > 0.0) n = rough(n, phase, 0.6 * rind);
	vec3 r = reflect(-v, n);
	float dull = mix(0.07, 0.5, rind);
	vec3 bent = refract(-v, n, 0.73);
	Nearby around = nearby(berry, ${NEIGHBOURS}, point, n, r, bent, 0.12 + dull);
	float rubbed = smoothstep(0.0, 0.2 + 0.2 * fine, around.gap / sphere.w);
	float patches = smoothstep(0.18, 0.75, 0.75 * coarse + 0.35 * fine);
	float depth = 1.1 * bloom * tint.w * rubbed * mix(0.3, 1.0, patches) * (0.55 + 0.45 * n.y);
	float waxed = 1.0 - exp(-depth / (0.25 + nv));

	// The marks of pedicel and style.
	float along = dot(round, pose.xyz);
	float marked = smoothstep(0.984, 0.995, along + 0.006 * (fine - 0.5));
	float halo = smoothstep(0.9, 0.985, along) * (1.0 - marked);
	float seat = smoothstep(-0.9, -0.985, along);
	vec3 skin = tint.rgb * (0.86 + 0.28 * coarse) * (0.94 + 0.12 * fine);
	skin = mix(skin, skin * 1.25 + 0.02, 0.5 * halo + 0.4 * seat);
	skin = mix(skin, skin * (0.72 + 0.45 * fine), rind);
	skin = mix(skin, scar, marked * 0.9);

	// Light on the skin.
	float lit = key_light(berry, point);
	float nk = dot(n, keyDirection);
	float nb = dot(n, rimDirection);
	vec3 soft = translucency * (0.25 + 0.35 * sqrt(skin));
	vec3 dN = mat3(viewMatrix) * n;
	vec3 sky = diffuse_surroundings(dN);
	vec3 keyed = key.irradiance * (lit / 3.14159);
	vec3 rimmed = rim.irradiance * (lamps.y / 3.14159);
	vec3 white = keyed * clamp((nk + 0.1) / 1.1, 0.0, 1.0) + rimmed * clamp((nb + 0.1) / 1.1, 0.0, 1.0);
	vec3 wrapped = keyed * clamp((nk + soft) / (1.0 + soft), 0.0, 1.0) + rimmed * clamp((nb + soft) / (1.0 + soft), 0.0, 1.0);
	vec3 colour = skin * (wrapped + sky * bounced(around.sky, skin));

	// Light through the flesh: what the lamps send in on the other side, gathered towards the far pole, and what
	// stands behind the berry, seen through it.
	float farKey = clamp(-nk, 0.0, 1.0);
	float farRim = clamp(-nb, 0.0, 1.0);
	float gathered = 0.12 + 2.2 * farKey * farKey * farKey;
	vec3 glow = key.irradiance * lamps.x * (gathered * smoothstep(-0.25, 0.35, -nk)) * through(2.0 * farKey);
	glow += rim.irradiance * lamps.y * smoothstep(-0.3, 0.15, -nb) * exp(-2.0 * farRim) * through(0.9 + 1.1 * farRim);
	vec3 behind = gloss_surroundings(mat3(viewMatrix) * bent) * through(-2.0 * dot(bent, round));
	colour = mix(colour, colour * 0.35, translucency * 0.6) + translucency * (0.3183 * glow * mix(0.35, 1.0, around.sky) + behind * mix(0.04, 0.5, around.through));
	colour = mix(colour, wax * (white + sky * around.sky), waxed);

	// The mirror of the skin.
	float fresnel = 0.035 + 0.6 * pow(1.0 - nv, 5.0);
	float taut = (1.0 - 0.8 * waxed) * (1.0 - 0.75 * rind) * (1.0 - marked);
	vec3 dR = mat3(viewMatrix) * r;
	float blur = dull + 0.3 * waxed;
	vec3 mirror = key.radiance * (reflected_window(dR, key, blur) * lit) + rim.radiance * (reflected_window(dR, rim, 0.15 + blur) * lamps.y);
	mirror += gloss_surroundings(dR) * mix(0.15 * skin, vec3(1.0), around.mirror);
	colour += mirror * fresnel * taut;

	gl_FragColor = vec4(colour, 1.0);
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}
`;

/** The cap's mesh: rings of 1, RIM/4, RIM/2 and RIM corners from its middle to its rim. */
export function capMesh(): { positions: Float32Array; indices: Uint16Array } {
	const rings = [
		{ corners: RIM / 4, share: 0.45 },
		{ corners: RIM / 2, share: 0.76 },
		{ corners: RIM, share: 1 },
	];
	const positions = [0, 0, 0];
	const indices: number[] = [];
	let inner = { first: 0, corners: 1 };
	for (const { corners, share } of rings) {
		const first = positions.length / 3;
		for (let k = 0; k < corners; k++) positions.push(k / corners, share, 0);
		const ratio = corners / inner.corners;
		for (let k = 0; k < corners; k++) {
			const next = first + ((k + 1) % corners);
			const below = inner.first + (Math.floor((k + 1) / ratio) % inner.corners);
			const before = inner.first + (Math.floor(k / ratio) % inner.corners);
			indices.push(before, first + k, next);
			if (below !== before) indices.push(before, next, below);
		}
		inner = { first, corners };
	}
	return { positions: Float32Array.from(positions), indices: Uint16Array.from(indices) };
}

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
