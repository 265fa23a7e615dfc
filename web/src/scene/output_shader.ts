/** Light as the screen shows it: three's neutral tone mapping and sRGB's curve, without branches and powers. */
import { float } from "./glsl";

/** sRGB's curve as a sum of x^½, x^¼, x^⅛ and x, to two thousandths of white: roots cost less than powers. */
export const DISPLAY_CURVE = [0.662002687, 0.68412206, -0.323583601, -0.022541147] as const;

const [second, fourth, eighth, first] = DISPLAY_CURVE.map(float);

/** `displayed(light)`, in place of three's tonemapping_fragment and colorspace_fragment, for what is drawn on screen alone. */
export const OUTPUT_CHUNK = /* glsl */ `
vec3 displayed(vec3 light) {
	light *= toneMappingExposure;
	float least = min(light.r, min(light.g, light.b));
	light -= least < 0.08 ? least - 6.25 * least * least : 0.04;
	float peak = max(0.76, max(light.r, max(light.g, light.b)));
	float rolled = 1.0 - 0.0576 / (peak - 0.52);
	vec3 toned = mix(light * (rolled / peak), vec3(rolled), 1.0 - 1.0 / (0.15 * (peak - rolled) + 1.0));
	vec3 a = sqrt(max(vec3(0.0), toned));
	vec3 b = sqrt(a);
	return max(vec3(0.0), ${second} * a + ${fourth} * b + ${eighth} * sqrt(b) + ${first} * toned);
}
`;
