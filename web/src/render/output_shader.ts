/** Output of light to the screen: three's neutral tone mapping without branches, and the sRGB curve. */

/**
 * `displayed(light)` replaces three's tonemapping_fragment and colorspace_fragment in materials that are drawn on
 * screen only. The curve is the same as in all other materials, so that equal light gives equal colours.
 */
export const OUTPUT_CHUNK = /* glsl */ `
vec3 displayed(vec3 light) {
	light *= toneMappingExposure;
	float least = min(light.r, min(light.g, light.b));
	light -= least < 0.08 ? least - 6.25 * least * least : 0.04;
	float peak = max(0.76, max(light.r, max(light.g, light.b)));
	float rolled = 1.0 - 0.0576 / (peak - 0.52);
	vec3 toned = mix(light * (rolled / peak), vec3(rolled), 1.0 - 1.0 / (0.15 * (peak - rolled) + 1.0));
	return sRGBTransferOETF(vec4(max(vec3(0.0), toned), 1.0)).rgb;
}
`;
