import { describe, expect, it } from "vitest";
import { plantToSave } from "../../../web/src/app/files/plant_to_save";
import type { Plant } from "../../../web/src/plant/plant";
import { specimenFromPreset } from "../bunch";
import { studioWith } from "./context";

const opened = specimenFromPreset("long-conical");
const plant = (fingerprint: string) => ({ fingerprint }) as Plant;

async function studioWithPlant() {
	const { studio } = await studioWith(opened);
	studio.grew(plant("first"), opened);
	return studio;
}

describe("what is saved", () => {
	it("is the plant in view, in the look on the controls", async () => {
		const studio = await studioWithPlant();
		studio.set({ look: { skin: "ffffff" } });
		const { grown, from } = await plantToSave(studio);
		expect(grown.fingerprint).toBe("first");
		expect(from).toEqual({ ...opened, look: { ...opened.look, skin: "ffffff" } });
	});

	it("is awaited while it grows: never one plant's shape in another's look", async () => {
		const studio = await studioWithPlant();
		studio.choosePreset("lychee");
		const saved = plantToSave(studio);
		const lychee = studio.state.specimen;
		studio.grew(plant("second"), lychee);
		studio.caughtUp();
		expect(await saved).toMatchObject({ grown: { fingerprint: "second" }, from: lychee });
	});

	it("has the look of the time of the request", async () => {
		const studio = await studioWithPlant();
		studio.set({ parameters: { l: 400 } });
		const requested = studio.state.specimen;
		const saved = plantToSave(studio);
		studio.set({ look: { skin: "ffffff" } });
		studio.grew(plant("second"), requested);
		studio.caughtUp();
		expect((await saved).from).toEqual(requested);
	});

	it("is the plant in view, in its own look, if the awaited growth fails", async () => {
		const studio = await studioWithPlant();
		studio.choosePreset("lychee");
		const saved = plantToSave(studio);
		studio.caughtUp();
		expect(await saved).toMatchObject({ grown: { fingerprint: "first" }, from: opened });
	});

	it("rejects when it is cancelled", async () => {
		const studio = await studioWithPlant();
		studio.choosePreset("lychee");
		const cancel = new AbortController();
		const saved = plantToSave(studio, cancel.signal);
		cancel.abort(new Error("enough"));
		await expect(saved).rejects.toThrow("enough");
	});
});
