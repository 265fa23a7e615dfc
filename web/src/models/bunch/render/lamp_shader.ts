import type { LightUniforms } from "../../../render/light_shader";
import { RECORDS_PER_ROW } from "../../../render/record_texture";
import { CAST_RECORD, CASTERS } from "./casters";

/** Uniforms of every material of a bunch: the light, and its occluders. */
export type SharedUniforms = LightUniforms & {
	casterRecords: { value: unknown };
	/** 0 if only stems are shown: berries then cast no shadow. */
	berriesShown: { value: number };
};

/** Shader functions for the light that berries do not occlude, for vertex shaders; after LIGHT_CHUNK. */
export const LAMP_CHUNK = /* glsl */ `
uniform highp sampler2D casterRecords;
uniform float berriesShown;
vec4 caster_texel(int receiver, int texel) {
	return texelFetch(casterRecords, ivec2((receiver % ${RECORDS_PER_ROW}) * ${CAST_RECORD} + texel, receiver / ${RECORDS_PER_ROW}), 0);
}

// Share of the key light that passes the spheres in front of a point.
float key_share(int receiver, vec3 point) {
	float share = 1.0;
	for (int i = 0; i < ${CASTERS}; i++) {
		vec4 s = caster_texel(receiver, 1 + i);
		if (s.w <= 0.0) break;
		vec3 d = s.xyz - point;
		float along = dot(d, keyDirection);
		float lateral = sqrt(max(0.0, dot(d, d) - along * along));
		float blur = max(along * key.spread, 0.02 * s.w);
		float most = min(1.0, s.w * s.w / (blur * blur));
		share *= 1.0 - most * (1.0 - smoothstep(s.w - blur, s.w + blur, lateral)) * step(0.0, along);
	}
	return share;
}

// That share, and the share of the rim light that reaches the receiver's centre.
vec2 shares_of(int receiver, vec3 point) {
	return berriesShown < 0.5 ? vec2(1.0) : vec2(key_share(receiver, point), caster_texel(receiver, 0).y);
}
`;
