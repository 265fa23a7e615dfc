import { describe, expect, it } from "vitest";
import { samplesFor } from "../../../web/src/render/fine_picture";

describe("samplesFor", () => {
	it("returns the wanted samples of usual pictures, and one where the drawing would be too large", () => {
		expect(samplesFor({ width: 1200, height: 1500 }, 2)).toBe(2);
		expect(samplesFor({ width: 8192, height: 8192 }, 2)).toBe(1);
		expect(samplesFor({ width: 2048, height: 2048 }, 2)).toBe(2);
	});
});
