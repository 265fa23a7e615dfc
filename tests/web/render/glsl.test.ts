import { describe, expect, it } from "vitest";
import { float, step, vec3 } from "../../../web/src/render/glsl";

describe("numbers in shaders", () => {
	it("are floats even if they are integers", () => {
		expect([float(2), float(-1), float(0.25)]).toEqual(["2.0", "-1.0", "0.25"]);
		expect(vec3([1, 0.5, 0])).toBe("vec3(1.0, 0.5, 0.0)");
		expect(step([0.13, 0], "v")).toBe("smoothstep(0.13, 0.0, v)");
	});
});
