import { NOISE_CHUNK } from "../../../plant/noise";
import { float, step, vec3 } from "../../../render/glsl";
import { LIGHT_CHUNK } from "../../../render/light_shader";
import { OUTPUT_CHUNK } from "../../../render/output_shader";
import { WIND_CHUNK } from "../../../render/wind_shader";
import {
	AMBER,
	AMONG_CLEAR,
	BROWNED,
	COARSE,
	CREVICE,
	FINE,
	FURROWS,
	HALO,
	MOTTLE,
	RIND,
	SCAR,
	SEAT,
	WAX,
} from "../parts/skin_rules";
import { VERTICES_PER_ROW } from "./berry_skins";
import { FLESH_CHUNK } from "./flesh_shader";
import { LAMP_CHUNK } from "./lamp_shader";
import { SKIN_CHUNK } from "./skin_shader";

/** Varyings from vertices to pixels: values smooth enough over a berry to be computed at its few hundred vertices. */
const VARYINGS = /* glsl */ `
flat varying vec4 pose;
flat varying vec4 form;
flat varying vec2 dress;
varying vec4 place;
varying vec4 facing;
varying vec4 chart;
varying vec4 glow;
varying vec4 hue;
varying vec4 ambient;
varying vec4 mirrored;
varying vec3 toEye;
`;

/**
 * Vertex shader. An instance is a berry with the attributes of berry_instances.ts; \`uv\` is its pattern's, and its
 * vertices are fetched from a texture (packVertices).
 */
export const BERRY_VERTEX = /* glsl */ `
attribute vec4 centre;
attribute vec4 nature;
attribute vec4 posed;
attribute vec4 ripened;
attribute vec4 unripened;
attribute vec4 formed;
${VARYINGS}
uniform highp usampler2D vertexRecords;
uniform int patternVertices;
uniform float highlighted;
uniform vec3 sunward;
uniform float amber;
${LIGHT_CHUNK}
${LAMP_CHUNK}
${NOISE_CHUNK}
${FLESH_CHUNK}
${WIND_CHUNK}
vec2 halves(uint word) {
	return vec2(word & 0xffffu, word >> 16u) / ${float(65535 / 2)} - 1.0;
}
vec3 octahedral(uint word) {
	vec2 at = halves(word);
	vec3 n = vec3(at, 1.0 - abs(at.x) - abs(at.y));
	float below = max(-n.z, 0.0);
	n.xy -= below * vec2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
	return normalize(n);
}
void main() {
	int berry = int(nature.x);
	int index = berry * patternVertices + gl_VertexID;
	uvec3 record = texelFetch(vertexRecords, ivec2(index % ${VERTICES_PER_ROW}, index / ${VERTICES_PER_ROW}), 0).xyz;
	vec3 from = centre.w * vec3(halves(record.x), halves(record.y).x);
	vec3 point = centre.xyz + from;
	vec3 n = octahedral(record.z);
	float sky = float(record.y >> 24u) / 255.0;
	pose = posed;
	form = formed;
	dress = vec2(ripened.w, nature.x == highlighted ? 1.0 : 0.0);
	toEye = cameraPosition - point;
	place = vec4(from, 0.0);
	facing = vec4(n, 1.0);
	chart = vec4(uv, float((record.y >> 16u) & 0xffu) / 255.0, 0.5);
	glow = vec4(0.0, 0.0, 0.0, sky);
	hue = ambient = mirrored = vec4(0.0);
	gl_Position = projectionMatrix * viewMatrix * vec4(blown(point, point), 1.0);

	vec3 v = normalize(toEye);
	float nv = dot(n, v);
	// A vertex facing away: so do all triangles at it.
	if (nv < -0.3) return;
	vec2 lamps = caster_texel(berry, 0).xy;
	vec3 at = in_ball(from, pose.xyz, form);
	chart.w = noise(at * ${float(COARSE.cells)} + pose.w * ${float(COARSE.phase)});
	place.w = lamps.y;
	facing.w = key_share(berry, point);

	// Colour by how far it has turned. Colours of pigments mix as logarithms.
	float turned = turned_at(unripened.w, dot(at, pose.xyz), chart.w, 0.5);
	hue = vec4(exp(mix(unripened.rgb, ripened.rgb, turned)), clearness(turned, form));
	float gilt = 0.0;
	if (amber > 0.0) {
		gilt = amber * nature.z * turned * smoothstep(${float(AMBER.from)}, ${float(AMBER.to)}, dot(at, sunward) + ${float(AMBER.coarse)} * (chart.w - 0.5));
		hue.rgb *= mix(vec3(1.0), ${vec3(AMBER.colour)}, gilt);
	}

	// Ambient light and reflections. Neighbours hide the sky from the horizon up: the visible part is approximated by a
	// cone about the normal.
	mat3 toView = mat3(viewMatrix);
	ambient = vec4(diffuse_surroundings(toView * n), 1.0);
	float cone = sqrt(1.0 - sky);
	mirrored = vec4(gloss_surroundings(toView * reflect(-v, n)), smoothstep(cone - 0.3, cone + 0.1, nv));

	if (hue.w > 0.03) {
		vec3 bent = refract(-v, n, 0.73);
		Path path = path_inside(at, bent, pose.xyz, form);
		vec3 absorption = mix(unripeAbsorption, ripeAbsorption, turned) - gilt * ${vec3(AMBER.colour.map(Math.log))} + form.z * ${vec3(BROWNED)};
		vec3 keyward = towards_in_ball(keyDirection, pose.xyz, form);
		vec3 rimward = towards_in_ball(rimDirection, pose.xyz, form);
		glow.rgb = 0.11 * mix(0.35, 1.0, sky) * scattered(path, absorption, keyward, key.irradiance * lamps.x, rimward, rim.irradiance * lamps.y);
		// Light scattered many times in the flesh comes out on all sides, in its colour: the berry glows, most where it
		// is lit.
		float facingKey = 0.5 + 0.5 * dot(n, keyDirection);
		vec3 within = key.irradiance * (lamps.x * mix(0.15, 0.6, facingKey)) + rim.irradiance * (0.4 * lamps.y) + 3.2 * ambient.rgb * mix(0.7, 1.0, sky);
		glow.rgb += 0.065 * within * exp(-1.2 * absorption);
		// The background is not sampled: the more neighbours a berry has, the less is seen through it.
		glow.rgb += gloss_surroundings(toView * bent) * exp(-absorption * path.run) * mix(0.03, 0.4, nature.y * nature.y);
	}
}
`;

/** Fragment shader: the skin, the flesh behind it and the wax on it. */
export const BERRY_FRAGMENT = /* glsl */ `
${VARYINGS}
uniform vec3 wax;
uniform vec3 grooves;
uniform vec2 grooveDepth;
uniform float scar;
uniform float bloom;
uniform float seedsSeen;
${LIGHT_CHUNK}
${NOISE_CHUNK}
${FLESH_CHUNK}
${SKIN_CHUNK}
${OUTPUT_CHUNK}

void main() {
	vec3 axis = pose.xyz;
	float phase = pose.w;
	float shrivel = form.z;
	float pressed = chart.z;
	float coarse = chart.w;
	vec3 v = normalize(toEye);
	vec3 n = normalize(facing.xyz);
	vec3 at = in_ball(place.xyz, axis, form);
	float fine = noise(at * ${float(FINE.cells)} + phase * ${float(FINE.phase)});

	// The skin's relief.
	float high = grooveDepth.y > 0.5 ? smoothstep(grooveDepth.x, grooveDepth.y, length(at)) : 1.0;
	float furrows = max(${float(FURROWS.rind)} * rind, ${float(FURROWS.shrivel)} * shrivel);
	vec3 sky = ambient.rgb;
	vec3 around = mirrored.rgb;
	if (furrows > ${float(FURROWS.least)}) {
		n = rough(n, at * mix(${float(FURROWS.onRinds.cells)}, ${float(FURROWS.onRaisins.cells)}, step(rind, ${float(RIND.from)})) + phase * ${float(FURROWS.onRinds.phase)}, furrows);
		sky = diffuse_surroundings(mat3(viewMatrix) * n);
		around = gloss_surroundings(mat3(viewMatrix) * reflect(-v, n));
	}
	float nv = clamp(dot(n, v), 0.0, 1.0);
	float dull = mix(0.07, 0.5, max(rind, 0.6 * shrivel));
	float open = glow.w * (1.0 - ${float(CREVICE.pressed)} * pressed) * mix(${float(1 - CREVICE.groove)}, 1.0, high);

	// Colour, mottled, marked at pedicel and style.
	vec3 skin = hue.rgb;
	skin *= (${float(MOTTLE.least)} + ${float(MOTTLE.span)} * mix(0.5, coarse, ${float(MOTTLE.share)} + ${float(MOTTLE.uneven)} * uneven)) * (0.94 + 0.12 * fine);
	skin = mix(skin * grooves, skin, high);
	skin = mix(skin, skin * (${float(RIND.least)} + ${float(RIND.span)} * fine), rind);
	float dots = lenticels > 0.0 ? lenticels * lenticel(at, phase) : 0.0;
	skin = mix(skin, 0.55 * skin + vec3(0.17, 0.145, 0.1), 0.8 * dots);
	float marked = 0.0;
	float halo = 0.0;
	if (chart.y > scar - ${float(HALO.width)}) {
		marked = smoothstep(scar - ${float(SCAR.edge)}, scar, chart.y + 0.01 * (fine - 0.5));
		halo = smoothstep(scar - ${float(HALO.width)}, scar - ${float(HALO.end)}, chart.y) * (1.0 - marked);
		skin = mix(skin, skin * ${float(HALO.skin)} + ${float(HALO.light)}, ${float(HALO.share)} * halo);
		skin = mix(skin, ${vec3(SCAR.colour)} * (0.6 + 0.8 * fine) + ${float(SCAR.skin)} * skin, marked * ${float(SCAR.share)});
	} else if (chart.y < ${float(SEAT.to + 0.015)}) {
		float seat = ${step([SEAT.to, SEAT.from], "chart.y + 0.03 * (fine - 0.5)")};
		skin = mix(skin, skin * ${float(SEAT.skin)} + ${vec3(SEAT.colour)}, ${float(SEAT.share)} * seat);
	}

	// Wax: all over, thinner below, patchy, rubbed off where berries touch or are brushed.
	float waxed = 0.0;
	if (bloom > 0.0) {
		float rubbed = (1.0 - ${step(WAX.pressed, `pressed + ${float(WAX.pressedFine)} * (fine - 0.5)`)}) * ${step(WAX.brushed, `coarse + ${float(WAX.fine)} * fine`)};
		float patches = ${step(WAX.patches, `${float(WAX.coarseShare)} * coarse + ${float(WAX.fineShare)} * fine`)};
		float depth = ${float(WAX.depth)} * bloom * dress.x * mix(${float(WAX.rubbed)}, 1.0, rubbed) * mix(${float(WAX.bare)}, 1.0, patches) * (${float(WAX.side)} + ${float(WAX.up)} * n.y);
		waxed = (1.0 - exp(-depth / (${float(WAX.grazing)} + nv))) * (1.0 - marked) * (1.0 - ${float(WAX.dry)} * shrivel);
	}

	// Light on the skin.
	float lit = facing.w;
	float nk = dot(n, keyDirection);
	float nb = dot(n, rimDirection);
	float clear = hue.w * (1.0 - 0.6 * marked);
	vec3 keyed = key.irradiance * (lit * 0.31831);
	vec3 rimmed = rim.irradiance * (place.w * 0.31831);
	vec3 white = keyed * clamp((nk + 0.1) * 0.90909, 0.0, 1.0) + rimmed * clamp((nb + 0.1) * 0.90909, 0.0, 1.0);
	vec3 soft = clear * (0.25 + 0.35 * sqrt(skin));
	vec3 share = 1.0 / (1.0 + soft);
	vec3 wrapped = keyed * clamp((nk + soft) * share, 0.0, 1.0) + rimmed * clamp((nb + soft) * share, 0.0, 1.0);
	vec3 albedo = mix(skin, sqrt(skin) * ${vec3(AMONG_CLEAR)}, clear);
	vec3 colour = skin * (wrapped + sky * bounced(open, albedo));

	// Light through the flesh, reduced by seeds.
	if (clear > 0.03) {
		vec3 through = glow.rgb;
		if (veins > 0.0) through *= 1.0 + 0.45 * veins * (vein(chart.xy, fine) - 0.3);
		if (seedsSeen * form.w > 0.0) {
			float shade = seed_shade(path_inside(at, refract(-v, n, 0.73), axis, form), axis, form, phase);
			through *= 1.0 - seedsSeen * shade * vec3(0.6, 0.7, 0.75);
		}
		colour = mix(colour, colour * 0.35, clear * 0.6) + clear * through * (1.0 - 0.5 * dots);
	}
	colour = mix(colour, wax * (white + sky * open), waxed);

	// Specular reflection of the skin.
	float grazing = 1.0 - nv;
	float fresnel = 0.035 + 0.6 * grazing * grazing * grazing * grazing * grazing;
	float taut = (1.0 - 0.8 * waxed) * (1.0 - 0.75 * rind) * (1.0 - 0.7 * shrivel) * (1.0 - 0.7 * marked) * (1.0 - 0.6 * dots) * (1.0 - 0.85 * pressed) * (1.0 - 0.8 * halo);
	vec3 r = reflect(-v, n);
	float blur = dull + 0.3 * waxed;
	vec3 mirror = around * mix(0.15 * skin, vec3(1.0), mirrored.w);
	if (lit > 0.0 && near_window(dot(r, keyDirection), key.extent.xy, blur)) mirror += key.radiance * (reflected_window(key.toFrame * (mat3(viewMatrix) * r), key.extent, blur) * lit);
	if (place.w > 0.0 && near_window(dot(r, rimDirection), rim.extent.xy, 0.15 + blur)) mirror += rim.radiance * (reflected_window(rim.toFrame * (mat3(viewMatrix) * r), rim.extent, 0.15 + blur) * place.w);
	colour += mirror * fresnel * taut;

	// The highlighted berry: brighter, with a bright outline.
	if (dress.y > 0.5) colour = mix(1.25 * colour + 0.04, vec3(1.0, 0.93, 0.82), 0.85 * smoothstep(0.55, 0.25, nv));

	gl_FragColor = vec4(displayed(colour), 1.0);
}
`;
