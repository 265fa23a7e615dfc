import { expect, it } from "vitest";
import { isAsPrinted, setAsPrinted } from "../../../../../web/src/models/bunch/ui/as_printed";
import { bunchContext, studioWith } from "../../../app/context";
import { specimenFromPreset } from "../../../bunch";

const opened = specimenFromPreset("grape-15c");

it("switches to the printed method and back to the previous values", async () => {
	const { studio } = await studioWith(opened);
	const context = bunchContext(studio);
	studio.set({ parameters: { fit: 0.5, vary: 0.7 } });
	setAsPrinted(context, true);
	expect(isAsPrinted(context.state.specimen)).toBe(true);
	setAsPrinted(context, false);
	expect(studio.state.specimen.parameters).toMatchObject({ fit: 0.5, vary: 0.7 });
});

it("restores the preset's values if none were stored, and never stores the printed method's", async () => {
	const { studio } = await studioWith(opened);
	const context = bunchContext(studio);
	studio.set({ parameters: { fit: 0, vary: 0 } });
	setAsPrinted(context, true);
	setAsPrinted(context, false);
	expect(studio.state.specimen).toEqual(opened);
});
