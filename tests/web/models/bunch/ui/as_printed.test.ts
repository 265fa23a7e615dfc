import { expect, it } from "vitest";
import { isAsPrinted, setAsPrinted } from "../../../../../web/src/models/bunch/ui/as_printed";
import { bunchContext, studioWith } from "../../../app/context";
import { specimenFromPreset } from "../../../bunch";

const opened = specimenFromPreset("grape-15c");

it("switches to the paper's letter and back to what was before", async () => {
	const { studio } = await studioWith(opened);
	const desk = bunchContext(studio);
	studio.set({ parameters: { fit: 0.5, vary: 0.7 } });
	setAsPrinted(desk, true);
	expect(isAsPrinted(desk.state.specimen)).toBe(true);
	setAsPrinted(desk, false);
	expect(studio.state.specimen.parameters).toMatchObject({ fit: 0.5, vary: 0.7 });
});

it("goes back to the preset's where nothing is remembered, and does not remember the letter itself", async () => {
	const { studio } = await studioWith(opened);
	const desk = bunchContext(studio);
	studio.set({ parameters: { fit: 0, vary: 0 } });
	setAsPrinted(desk, true);
	setAsPrinted(desk, false);
	expect(studio.state.specimen).toEqual(opened);
});
