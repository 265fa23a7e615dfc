/** Who stands in whose light: the records of receivers and casters, read by shaders. */
import type { LightUniforms } from "../../../scene/light_shader";
import { RECORDS_PER_ROW } from "../../../scene/record_texture";
import { CAST_RECORD, CASTERS } from "./casters";
import { FAR, RECORD } from "./receivers";

/** What every material of a bunch is made with: the light, and what else they share. */
export type SharedUniforms = LightUniforms & Record<string, { value: unknown }>;

/** Fetching records; for vertex and fragment shaders. */
export const RECORD_CHUNK = /* glsl */ `
uniform highp sampler2D receiverRecords;
uniform highp sampler2D casterRecords;
vec4 receiver_texel(int receiver, int texel) {
	return texelFetch(receiverRecords, ivec2((receiver % ${RECORDS_PER_ROW}) * ${RECORD} + texel, receiver / ${RECORDS_PER_ROW}), 0);
}
vec4 caster_texel(int receiver, int texel) {
	return texelFetch(casterRecords, ivec2((receiver % ${RECORDS_PER_ROW}) * ${CAST_RECORD} + texel, receiver / ${RECORDS_PER_ROW}), 0);
}
`;

/**
 * What berries leave of the light at a point; after LIGHT_CHUNK. Directions \`n\`, \`r\`, \`bent\` are the bunch's own, \`p\` is the
 * point relative to its receiver's centre.
 */
export const SHADE_CHUNK = /* glsl */ `
struct Nearby { float sky; float mirror; float through; };
uniform float berriesShown;

float sky_hidden(float sine, float cosine) {
	float low = cosine + sine;
	float lifted = cosine >= sine ? cosine : low * low / (4.0 * sine);
	return low <= 0.0 ? 0.0 : sine * sine * lifted;
}

// What the nearest spheres and the far ones leave of the sky, of the mirror lobe and of what is seen through the flesh
// along \`bent\`.
Nearby nearby(int receiver, int neighbours, vec3 p, vec3 n, vec3 r, vec3 bent, float blur) {
	Nearby result = Nearby(1.0, 1.0, 1.0);
	if (berriesShown < 0.5) return result;
	vec4 far = receiver_texel(receiver, ${FAR});
	result.sky = exp(-max(0.0, far.x + dot(far.yzw, n)));
	result.mirror = exp(-max(0.0, far.x + dot(far.yzw, r)));
	result.through = exp(-2.0 * max(0.0, far.x + dot(far.yzw, bent)));
	for (int i = 0; i < neighbours; i++) {
		vec4 s = receiver_texel(receiver, ${FAR + 1} + i);
		if (s.w <= 0.0) break;
		vec3 d = s.xyz - p;
		float away = max(length(d), s.w * 1.001);
		d /= away;
		float sine = s.w / away;
		result.sky *= 1.0 - sky_hidden(sine, dot(n, d));
		float edge = sqrt(1.0 - sine * sine);
		result.mirror *= 1.0 - smoothstep(edge - blur, edge + blur, dot(r, d));
		result.through *= 1.0 - smoothstep(edge - 0.35, edge + 0.35, dot(bent, d));
	}
	return result;
}

// Share of the key light that passes the spheres in its way.
float key_light(int receiver, vec3 p) {
	float share = 1.0;
	if (berriesShown < 0.5) return share;
	for (int i = 0; i < ${CASTERS}; i++) {
		vec4 s = caster_texel(receiver, 1 + i);
		if (s.w <= 0.0) break;
		vec3 d = s.xyz - p;
		float along = dot(d, keyDirection);
		float lateral = sqrt(max(0.0, dot(d, d) - along * along));
		float blur = max(along * key.spread, 0.02 * s.w);
		float most = min(1.0, s.w * s.w / (blur * blur));
		share *= 1.0 - most * (1.0 - smoothstep(s.w - blur, s.w + blur, lateral)) * step(0.0, along);
	}
	return share;
}
`;
