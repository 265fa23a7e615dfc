import { ShaderChunk } from "three";
import { describe, expect, it } from "vitest";
import { OUTPUT_CHUNK } from "../../../web/src/render/output_shader";

/** Khronos' neutral tone mapping as its specification has it, with its branch. */
function neutral(light: number[]): number[] {
	const start = 0.8 - 0.04;
	const least = Math.min(...light);
	const offset = least < 0.08 ? least - 6.25 * least * least : 0.04;
	const toned = light.map((value) => value - offset);
	const peak = Math.max(...toned);
	if (peak < start) return toned;
	const d = 1 - start;
	const rolled = 1 - (d * d) / (peak + d - start);
	const share = 1 - 1 / (0.15 * (peak - rolled) + 1);
	return toned.map((value) => value * (rolled / peak) * (1 - share) + rolled * share);
}

/** The chunk's arithmetic, with its numbers read from its text. */
function branchless(light: number[]): number[] {
	const [start, squared, shift] = ["max\\(([\\d.]+), max", "1.0 - ([\\d.]+) / \\(peak", "peak - ([\\d.]+)\\)"].map(
		(at) => Number(new RegExp(at).exec(OUTPUT_CHUNK)?.[1]),
	);
	const least = Math.min(...light);
	const offset = least < 0.08 ? least - 6.25 * least * least : 0.04;
	const toned = light.map((value) => value - offset);
	const peak = Math.max(start, ...toned);
	const rolled = 1 - squared / (peak - shift);
	const share = 1 - 1 / (0.15 * (peak - rolled) + 1);
	return toned.map((value) => value * (rolled / peak) * (1 - share) + rolled * share);
}

describe("light as the screen shows it", () => {
	it("ends with three's own sRGB curve, like every other material", () => {
		expect(OUTPUT_CHUNK).toMatch(/return sRGBTransferOETF\(vec4\(max\(vec3\(0\.0\), toned\), 1\.0\)\)\.rgb;/);
		expect(ShaderChunk.colorspace_pars_fragment).toContain("vec4 sRGBTransferOETF( in vec4 value )");
	});

	it("compresses highlights like Khronos' neutral tone mapping", () => {
		for (const light of [
			[0.02, 0.3, 0.5],
			[0.5, 0.6, 0.7],
			[0.9, 0.8, 0.3],
			[3, 2, 0.5],
			[12, 11, 10],
		]) {
			const expected = neutral(light);
			branchless(light).forEach((value, k) => {
				expect(value).toBeCloseTo(expected[k], 6);
			});
		}
	});
});
