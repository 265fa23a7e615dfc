import { NOISE_CHUNK } from "../../../plant/noise";
import { float, step, vec3 } from "../../../scene/glsl";
import { LIGHT_CHUNK } from "../../../scene/light_shader";
import { COARSE, HALO, MOTTLE, RIND, SCAR, SEAT, WAX } from "../parts/skin_rules";
import { VERTICES_PER_ROW } from "./berry_skins";
import { FLESH_CHUNK } from "./flesh_shader";
import { RECORD_CHUNK, SHADE_CHUNK } from "./occlusion_shader";
import { NEIGHBOURS } from "./receivers";
import { SKIN_CHUNK } from "./skin_shader";

/** What a vertex hands to the pixels: whatever is smooth enough over a berry to be settled at its few hundred vertices. */
const VARYINGS = /* glsl */ `
flat varying int berry;
flat varying vec4 pose;
flat varying vec4 ripe;
flat varying vec4 unripe;
flat varying vec4 form;
varying vec4 place;
varying vec4 facing;
varying vec4 chart;
varying vec4 glow;
`;

/** An instance is a berry: \`uv\` is its pattern's, its vertices are fetched from a texture (packVertices). */
export const BERRY_VERTEX = /* glsl */ `
attribute float receiver;
${VARYINGS}
uniform highp usampler2D vertexRecords;
uniform int patternVertices;
${RECORD_CHUNK}
${LIGHT_CHUNK}
${SHADE_CHUNK}
${NOISE_CHUNK}
${FLESH_CHUNK}
vec3 octahedral(uint word) {
	vec2 at = vec2((word >> 8u) & 0xfffu, word >> 20u) / ${(4095 / 2).toFixed(1)} - 1.0;
	vec3 n = vec3(at, 1.0 - abs(at.x) - abs(at.y));
	float below = max(-n.z, 0.0);
	n.xy -= below * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
	return normalize(n);
}
void main() {
	berry = int(receiver);
	int index = berry * patternVertices + gl_VertexID;
	uvec4 record = texelFetch(vertexRecords, ivec2(index % ${VERTICES_PER_ROW}, index / ${VERTICES_PER_ROW}), 0);
	vec3 point = uintBitsToFloat(record.xyz);
	vec3 n = octahedral(record.w);
	vec2 lamps = caster_texel(berry, 0).xy;
	pose = receiver_texel(berry, 1);
	ripe = receiver_texel(berry, 2);
	unripe = receiver_texel(berry, 3);
	form = receiver_texel(berry, 4);
	place = vec4(point - receiver_texel(berry, 0).xyz, lamps.y);
	facing = vec4(n, 1.0);
	chart = vec4(uv, float(record.w & 0xffu) / 255.0, 0.5);
	glow = vec4(0.0);
	gl_Position = projectionMatrix * viewMatrix * vec4(point, 1.0);

	vec3 v = normalize(cameraPosition - point);
	// Out of sight, and so is every triangle it is a corner of.
	if (dot(n, v) < -0.3) return;
	vec3 at = in_ball(place.xyz, pose.xyz, form);
	chart.w = noise(at * ${float(COARSE.cells)} + pose.w * ${float(COARSE.phase)});
	vec3 bent = refract(-v, n, 0.73);
	Nearby around = nearby(berry, ${NEIGHBOURS}, place.xyz, n, reflect(-v, n), bent, 0.19);
	facing.w = around.mirror;
	glow.w = around.sky;
	float turned = turned_at(unripe.w, dot(at, pose.xyz), chart.w, 0.5);
	if (clearness(turned, form) > 0.03) {
		Path path = path_inside(at, bent, pose.xyz, form);
		vec3 absorption = mix(unripeAbsorption, ripeAbsorption, turned);
		vec3 keyward = towards_in_ball(keyDirection, pose.xyz, form);
		vec3 rimward = towards_in_ball(rimDirection, pose.xyz, form);
		glow.rgb = 0.11 * mix(0.35, 1.0, around.sky) * scattered(path, absorption, keyward, key.irradiance * lamps.x, rimward, rim.irradiance * lamps.y);
		glow.rgb += gloss_surroundings(mat3(viewMatrix) * bent) * exp(-absorption * path.run) * mix(0.03, 0.4, around.through);
	}
}
`;

/** The skin, the flesh behind it and the wax on it. */
export const BERRY_FRAGMENT = /* glsl */ `
${VARYINGS}
uniform vec3 wax;
uniform vec3 grooves;
uniform vec2 grooveDepth;
uniform float scar;
uniform float bloom;
uniform float seedsSeen;
uniform int highlighted;
${RECORD_CHUNK}
${LIGHT_CHUNK}
${SHADE_CHUNK}
${NOISE_CHUNK}
${FLESH_CHUNK}
${SKIN_CHUNK}

void main() {
	vec3 axis = pose.xyz;
	float phase = pose.w;
	float shrivel = form.z;
	float pressed = chart.z;
	float coarse = chart.w;
	vec3 v = normalize(cameraPosition - receiver_texel(berry, 0).xyz - place.xyz);
	vec3 n = normalize(facing.xyz);
	vec3 at = in_ball(place.xyz, axis, form);
	float fine = noise(at * 9.0 + phase * 23.0);

	// The skin's relief.
	float high = smoothstep(grooveDepth.x, grooveDepth.y, length(at));
	float furrows = max(0.5 * rind, 0.15 * shrivel);
	if (furrows > 0.02) n = rough(n, at * mix(13.0, 7.0, step(rind, 0.1)) + phase * 41.0, furrows);
	float nv = clamp(dot(n, v), 0.0, 1.0);
	vec3 r = reflect(-v, n);
	float dull = mix(0.07, 0.5, max(rind, 0.6 * shrivel));
	float open = glow.w * (1.0 - 0.55 * pressed) * mix(0.6, 1.0, high);

	// Its colour: turned or not, mottled, marked where pedicel and style were. Pigment absorbs: colours mix as logarithms do.
	float along = dot(at, axis);
	float turned = turned_at(unripe.w, along, coarse, fine);
	vec3 skin = exp(mix(unripe.rgb, ripe.rgb, turned));
	skin *= (${float(MOTTLE.least)} + ${float(MOTTLE.span)} * mix(0.5, coarse, ${float(MOTTLE.share)} + ${float(MOTTLE.uneven)} * uneven)) * (0.94 + 0.12 * fine);
	skin = mix(skin * grooves, skin, high);
	skin = mix(skin, skin * (${float(RIND.least)} + ${float(RIND.span)} * fine), rind);
	float dots = lenticels > 0.0 ? lenticels * lenticel(at, phase) : 0.0;
	skin = mix(skin, 0.55 * skin + vec3(0.17, 0.145, 0.1), 0.8 * dots);
	float marked = smoothstep(scar - 0.006, scar, chart.y + 0.01 * (fine - 0.5));
	float halo = smoothstep(scar - ${float(HALO.width)}, scar - ${float(HALO.end)}, chart.y) * (1.0 - marked);
	float seat = ${step([SEAT.to, SEAT.from], "chart.y + 0.03 * (fine - 0.5)")};
	skin = mix(skin, skin * ${float(HALO.skin)} + ${float(HALO.light)}, ${float(HALO.share)} * halo);
	skin = mix(skin, skin * ${float(SEAT.skin)} + ${vec3(SEAT.colour)}, ${float(SEAT.share)} * seat);
	skin = mix(skin, ${vec3(SCAR.colour)} * (0.6 + 0.8 * fine) + ${float(SCAR.skin)} * skin, marked * ${float(SCAR.share)});

	// Where wax lies: all over, thinner below, patchy, rubbed off where berries touch and where something brushed by.
	float rubbed = (1.0 - ${step(WAX.pressed, "pressed + 0.25 * (fine - 0.5)")}) * ${step(WAX.brushed, `coarse + ${float(WAX.fine)} * fine`)};
	float patches = ${step(WAX.patches, `${float(WAX.coarseShare)} * coarse + ${float(WAX.fineShare)} * fine`)};
	float depth = ${float(WAX.depth)} * bloom * ripe.w * mix(${float(WAX.rubbed)}, 1.0, rubbed) * mix(${float(WAX.bare)}, 1.0, patches) * (${float(WAX.side)} + ${float(WAX.up)} * n.y);
	float waxed = (1.0 - exp(-depth / (${float(WAX.grazing)} + nv))) * (1.0 - marked) * (1.0 - ${float(WAX.dry)} * shrivel);

	// Light on the skin.
	float lit = key_light(berry, place.xyz);
	float nk = dot(n, keyDirection);
	float nb = dot(n, rimDirection);
	float clear = clearness(turned, form) * (1.0 - marked);
	vec3 soft = clear * (0.25 + 0.35 * sqrt(skin));
	vec3 dN = mat3(viewMatrix) * n;
	vec3 sky = diffuse_surroundings(dN);
	vec3 keyed = key.irradiance * (lit / 3.14159);
	vec3 rimmed = rim.irradiance * (place.w / 3.14159);
	vec3 white = keyed * clamp((nk + 0.1) / 1.1, 0.0, 1.0) + rimmed * clamp((nb + 0.1) / 1.1, 0.0, 1.0);
	vec3 wrapped = keyed * clamp((nk + soft) / (1.0 + soft), 0.0, 1.0) + rimmed * clamp((nb + soft) / (1.0 + soft), 0.0, 1.0);
	vec3 colour = skin * (wrapped + sky * bounced(open, skin));

	// Light through the flesh, less where seeds stand in its way.
	if (clear > 0.03) {
		vec3 through = glow.rgb * (1.0 + 0.45 * veins * (vein(chart.xy, fine) - 0.3));
		if (seedsSeen * form.w > 0.0) {
			float shade = seed_shade(path_inside(at, refract(-v, n, 0.73), axis, form), axis, form, phase);
			through *= 1.0 - seedsSeen * shade * vec3(0.6, 0.7, 0.75);
		}
		colour = mix(colour, colour * 0.35, clear * 0.6) + clear * through * (1.0 - 0.5 * dots);
	}
	colour = mix(colour, wax * (white + sky * open), waxed);

	// The mirror of the skin.
	float fresnel = 0.035 + 0.6 * pow(1.0 - nv, 5.0);
	float taut = (1.0 - 0.8 * waxed) * (1.0 - 0.75 * rind) * (1.0 - 0.7 * shrivel) * (1.0 - marked) * (1.0 - 0.6 * dots) * (1.0 - 0.85 * pressed) * (1.0 - 0.8 * halo);
	vec3 dR = mat3(viewMatrix) * r;
	float blur = dull + 0.3 * waxed;
	vec3 mirror = key.radiance * (reflected_window(dR, key, blur) * lit) + rim.radiance * (reflected_window(dR, rim, 0.15 + blur) * place.w);
	mirror += gloss_surroundings(dR) * mix(0.15 * skin, vec3(1.0), facing.w);
	colour += mirror * fresnel * taut;

	// The berry pointed at: lifted, with a bright outline.
	if (berry == highlighted) colour = mix(1.25 * colour + 0.04, vec3(1.0, 0.93, 0.82), 0.85 * smoothstep(0.55, 0.25, nv));

	gl_FragColor = vec4(colour, 1.0);
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}
`;
