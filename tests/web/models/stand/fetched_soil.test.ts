import { expect, it, vi } from "vitest";
import { growPlant } from "../../../../web/src/generate/growth";
import { model } from "../../../../web/src/models/stand/index";
import type { StandPlant } from "../../../../web/src/models/stand/stand_plant";
import { planned, run } from "./stands";

const network = vi.hoisted(() => ({ down: true }));
vi.mock("../../../../web/src/models/stand/soil", async (original) => {
	if (network.down) throw new Error("No network.");
	return original();
});

/** Grows like the page, which continues without parts that cannot be fetched. */
const patient = {
	...model,
	prepare: (...of: Parameters<typeof model.prepare>) => model.prepare(...of)?.catch(() => {}),
};
const grown = async (meshes: boolean) =>
	(await growPlant(patient, planned("plants 1, random\ngrowth/figure-5: steps 1"), { meshes }, run)) as StandPlant;

it("adds a note to grounds without soil until the soil is loaded", async () => {
	const bare = await grown(true);
	expect(bare.meshes).toHaveLength(1);
	expect(bare.soil).toBeUndefined();
	expect(bare.notes).toEqual([expect.stringMatching(/^The soil could not be loaded, .*\.$/)]);
	expect((await grown(false)).notes).toEqual([]);
	network.down = false;
	const complete = await grown(true);
	expect(complete.soil).toBeDefined();
	expect(complete.notes).toEqual([]);
	expect(complete.fingerprint).toBe(bare.fingerprint);
});
