import { nothing, type TemplateResult } from "lit";
import { expect, it } from "vitest";
import { envelopePath } from "../../../../../web/src/models/bunch/profile/envelope";
import { drawOwn } from "../../../../../web/src/models/bunch/profile/profile_drawing";
import { DEFAULTS } from "./shape";

const { l, p3w, p3r, p4w, p4r, p5w, p5r, p6w, p6r } = DEFAULTS;
const own = { l, p3w, p3r, p4w, p4r, p5w, p5r, p6w, p6r };

it("the seed's own outline is drawn where it is not the handles'", () => {
	expect(drawOwn(DEFAULTS, undefined, "front")).toBe(nothing);
	expect(drawOwn(DEFAULTS, { ...own, l: l + 0.4 }, "front")).toBe(nothing);
	for (const view of ["front", "side"] as const) {
		const larger = { ...own, l: l + 60, p5w: p5w + 20 };
		const { values } = drawOwn(DEFAULTS, larger, view) as TemplateResult;
		expect(values).toEqual([envelopePath({ ...DEFAULTS, ...larger }, view)]);
	}
});
