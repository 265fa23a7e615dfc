import { expect, it } from "vitest";
import { GRAMMAR } from "../../../../web/src/models/grammar/schema";
import { fetchTexts } from "../../../../web/src/models/grammar/texts";
import { stepCount } from "../../../../web/src/models/grammar/ui/step_count";
import { fromPreset } from "../../../../web/src/specimen/from_preset";

const steps = (specimen: ReturnType<typeof shrub>) => {
	const [quantity] = stepCount.quantities?.(specimen) ?? [];
	return quantity;
};
const shrub = () => fromPreset(GRAMMAR, "monopodial-tree");

it("the number of steps is the text's, which a link need not repeat, or the document's own", async () => {
	await fetchTexts();
	const specimen = shrub();
	expect(steps(specimen).read(specimen, undefined)).toBe(10);
	expect(steps(specimen).change(specimen, 7, undefined)).toEqual({ details: { steps: 7 } });
	expect(steps(specimen).change(specimen, 10, undefined)).toEqual({ details: { steps: undefined } });
	expect(steps({ ...specimen, steps: 7 }).read({ ...specimen, steps: 7 }, undefined)).toBe(7);
});

it("the slider goes a few steps beyond the text's number, and as far as the document's own", async () => {
	await fetchTexts();
	expect(steps(shrub()).max).toBe(14);
	expect(steps({ ...shrub(), steps: 30 }).max).toBe(30);
	expect(steps(shrub())).toBe(steps(shrub()));
});
