import { expect, it } from "vitest";
import { changedIn } from "../../../web/src/element/grown_detail";
import { modelNamed } from "../../../web/src/models/index";
import { specimenFromPreset } from "../bunch";

it("a control's change applies, unless the page has replaced the model meanwhile", async () => {
	const bunch = await modelNamed("bunch");
	const document = { model: bunch, specimen: specimenFromPreset("riesling"), notes: [] };
	expect(changedIn(document, (now) => ({ ...now, seed: 9 })).specimen.seed).toBe(9);
	const other = { ...document.specimen, model: "leaf" };
	expect(changedIn(document, () => other).specimen).toBe(document.specimen);
});
