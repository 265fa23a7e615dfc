import { expect, it, vi } from "vitest";
import { cutOut, cutOutOf } from "../../../web/src/render/cut_out";

it("computes coverage and colour from pictures over black and over white", () => {
	const over = (ground: number) =>
		Uint8ClampedArray.from(
			[
				[200, 100, 40, 1],
				[200, 100, 40, 0.5],
				[200, 100, 40, 0],
			].flatMap(([red, green, blue, cover]) => [
				...[red, green, blue].map((value) => cover * value + (1 - cover) * ground),
				255,
			]),
		);
	const cut = cutOut(over(0), over(255));
	expect([...cut.subarray(0, 4)]).toEqual([200, 100, 40, 255]);
	for (const [k, value] of [200, 100, 40, 127.5].entries()) expect(Math.abs(cut[4 + k] - value)).toBeLessThan(3);
	expect([...cut.subarray(8)]).toEqual([0, 0, 0, 0]);
});

it("restores the background if there is no room for the picture", () => {
	vi.stubGlobal(
		"OffscreenCanvas",
		class {
			getContext = () => null;
		},
	);
	const drawn: unknown[] = [];
	const canvas = { width: 9000, height: 9000 } as HTMLCanvasElement;
	expect(() => cutOutOf(canvas, { width: 9000, height: 9000 }, (ground) => drawn.push(ground))).toThrow(
		"no room for 9000 × 9000 pixels",
	);
	expect(drawn).toEqual([0, undefined]);
	vi.unstubAllGlobals();
});
