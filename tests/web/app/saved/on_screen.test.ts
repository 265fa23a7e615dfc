import { describe, expect, it } from "vitest";
import { openSaved, savedOf } from "../../../../web/src/app/saved/on_screen";
import type { Studio } from "../../../../web/src/app/studio";
import { VERSION } from "../../../../web/src/app/version";
import type { Plant } from "../../../../web/src/plant/plant";
import { specimenFromPreset } from "../../bunch";
import { studioWith } from "../context";
import { savedAs } from "./saved_store";

const FINGERPRINT = "0123456789abcdef";
const GRAMMAR = "axiom: F\n/* of my own */";

/** The specimen on the controls has grown. */
function grow(studio: Studio, fingerprint = FINGERPRINT): void {
	studio.grew({ fingerprint } as Plant, studio.state.specimen);
	studio.caughtUp();
}

const messages = (studio: Studio) => studio.state.notices.map(({ title, details }) => [title, ...details].join(" "));

async function savedWithText() {
	const { studio } = await studioWith({ ...specimenFromPreset("riesling"), seed: 7, grammar: GRAMMAR } as never);
	grow(studio);
	return savedOf(studio, "Mine");
}

describe("what is on screen", () => {
	it("is saved as its link, with the text in the fragment, and its fingerprint; without a view it has no picture", async () => {
		const saved = await savedWithText();
		expect(saved).toMatchObject({ name: "Mine", app: VERSION, fingerprint: FINGERPRINT });
		expect(saved.link).toMatch(/^\?v=2&preset=riesling&seed=7#g=[\w-]+$/);
		expect(saved.picture).toBeUndefined();
	});

	it("is replaced by a saved specimen, its text included, as one undo step", async () => {
		const saved = await savedWithText();
		const { studio } = await studioWith(specimenFromPreset("duku"));
		const opening = openSaved(studio, saved);
		await expect.poll(() => studio.state.specimen).toMatchObject({ preset: "riesling", seed: 7, grammar: GRAMMAR });
		grow(studio);
		await opening;
		expect(messages(studio)).toEqual([]);
		studio.undo();
		expect(studio.state.specimen).toMatchObject({ preset: "duku" });
	});

	it("is reported if its fingerprint differs from the saved one", async () => {
		const { studio } = await studioWith(specimenFromPreset("duku"));
		const opening = openSaved(studio, savedAs("Old", { link: "?v=1&preset=grape-15b", fingerprint: FINGERPRINT }));
		await expect.poll(() => studio.state.specimen.preset).toBe("grape-15b");
		grow(studio, "fedcba9876543210");
		await opening;
		expect(messages(studio)).toEqual([
			`“Old” no longer matches the saved plant The plant’s fingerprint was 0123456789abcdef when version 1.0.0 saved it, but is fedcba9876543210 now.`,
		]);
	});

	it("is not compared if the document has changed meanwhile", async () => {
		const { studio } = await studioWith(specimenFromPreset("duku"));
		const opening = openSaved(studio, savedAs("Old", { link: "?v=2&preset=riesling", fingerprint: FINGERPRINT }));
		await expect.poll(() => studio.state.specimen.preset).toBe("riesling");
		studio.newVariation();
		grow(studio, "fedcba9876543210");
		await opening;
		expect(messages(studio)).toEqual([]);
	});
});
