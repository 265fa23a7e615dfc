import { beforeEach, describe, expect, it, vi } from "vitest";
import type { Studio } from "../../../web/src/app/studio";
import { currentAims, searchTarget, TARGET_SEARCH } from "../../../web/src/app/target_search";
import { MAX_GROWTHS } from "../../../web/src/targets/solve";
import { BUNCH, type Specimen, specimenFromPreset } from "../bunch";
import { studioWith } from "./context";

const KEYS = BUNCH.table.measures.map(({ key }) => key);

/** Measures of a plant whose length is proportional to `l`, and whose width is that of its widest side. */
function measured({ parameters }: Specimen): Float32Array {
	const values = new Float32Array(KEYS.length).fill(Number.NaN);
	values[KEYS.indexOf("bunch_length")] = 0.4 * parameters.l;
	values[KEYS.indexOf("bunch_width")] = Math.max(parameters.p3w, parameters.p4w) + 0.05 * parameters.l;
	return values;
}

let studio: Studio;
let services: Awaited<ReturnType<typeof studioWith>>["services"];
beforeEach(async () => {
	({ studio, services } = await studioWith(specimenFromPreset("riesling")));
	services.measure.mockImplementation(async (_, specimen) => measured(specimen as Specimen));
});

const length = () => studio.state.specimen.parameters.l;
const notices = () => studio.state.notices.map(({ title, details }) => [title, ...details].join(" | "));

describe("a search for a target value", () => {
	it("applies the result as one undo step, and shows a notice", async () => {
		const before = studio.state.specimen;
		await searchTarget(studio, { measure: "bunch_length", value: 160 });
		expect(length()).toBeCloseTo(400, -1);
		expect(notices()).toEqual([expect.stringMatching(/^Bunch length: 160 mm reached \| Length .*, after \d tries\.$/)]);
		expect(studio.toolState(TARGET_SEARCH).now).toBeUndefined();
		studio.undo();
		expect(studio.state.specimen).toBe(before);
		expect(notices()).toEqual([]);
	});

	it("meets earlier targets, too, until something else changes", async () => {
		await searchTarget(studio, { measure: "bunch_length", value: 160 });
		await searchTarget(studio, { measure: "bunch_width", value: 90 });
		expect(currentAims(studio)).toEqual([
			{ measure: "bunch_length", value: 160 },
			{ measure: "bunch_width", value: 90 },
		]);
		const values = measured(studio.state.specimen as Specimen);
		expect(values[KEYS.indexOf("bunch_length")]).toBeCloseTo(160, 0);
		expect(values[KEYS.indexOf("bunch_width")]).toBeCloseTo(90, 0);
		expect(notices()).toEqual([expect.stringMatching(/^Bunch width: 90 mm reached \| Bunch length: 160 mm reached/)]);
		studio.set({ parameters: { density: 3 } });
		expect(currentAims(studio)).toEqual([]);
	});

	it("reports its progress; cancelled, it leaves the document unchanged", async () => {
		const before = studio.state.specimen;
		const growths: number[] = [];
		services.measure.mockImplementation(async () => {
			const { now } = studio.toolState(TARGET_SEARCH);
			growths.push(now?.growths ?? -1);
			if (growths.length === 3) now?.cancel();
			return new Float32Array(KEYS.length).fill(growths.length);
		});
		await searchTarget(studio, { measure: "bunch_length", value: 160 });
		expect(growths).toEqual([0, 1, 2]);
		expect(growths.length).toBeLessThan(MAX_GROWTHS);
		expect(studio.state.specimen).toBe(before);
		expect(studio.toolState(TARGET_SEARCH)).toEqual({});
		expect(notices()).toEqual([]);
	});

	it("ends when the user changes the plant meanwhile", async () => {
		services.measure.mockImplementation(async (_, specimen) => {
			studio.edit({ parameters: { density: 2 } });
			return measured(specimen as Specimen);
		});
		await searchTarget(studio, { measure: "bunch_length", value: 160 });
		expect(services.measure).toHaveBeenCalledTimes(1);
		expect(studio.state.specimen.parameters).toMatchObject({
			density: 2,
			l: specimenFromPreset("riesling").parameters.l,
		});
	});

	it("retains the targets of the last result when a later search is cancelled", async () => {
		await searchTarget(studio, { measure: "bunch_length", value: 160 });
		services.measure.mockImplementation(async () => {
			studio.toolState(TARGET_SEARCH).now?.cancel();
			throw new Error("cancelled");
		});
		await searchTarget(studio, { measure: "bunch_width", value: 90 });
		expect(studio.toolState(TARGET_SEARCH).now).toBeUndefined();
		expect(currentAims(studio)).toEqual([{ measure: "bunch_length", value: 160 }]);
	});

	it("does not clear the progress of the search that replaced it", async () => {
		const waiting: ((values: Float32Array) => void)[] = [];
		services.measure.mockImplementation(() => new Promise((resolve) => waiting.push(resolve)));
		const first = searchTarget(studio, { measure: "bunch_length", value: 160 });
		await vi.waitFor(() => expect(waiting).toHaveLength(1));
		const second = searchTarget(studio, { measure: "bunch_width", value: 90 });
		waiting[0](new Float32Array(KEYS.length).fill(3));
		await first;
		expect(studio.toolState(TARGET_SEARCH).now).toMatchObject({ measure: "bunch_width" });
		await vi.waitFor(() => expect(waiting).toHaveLength(2));
		studio.toolState(TARGET_SEARCH).now?.cancel();
		waiting[1](new Float32Array(KEYS.length).fill(3));
		await second;
		expect(studio.toolState(TARGET_SEARCH)).toEqual({});
	});

	it("reports the error", async () => {
		services.measure.mockRejectedValue(new Error("no core"));
		await searchTarget(studio, { measure: "bunch_length", value: 160 });
		expect(notices()).toEqual(["Could not search for that value | no core"]);
		expect(studio.toolState(TARGET_SEARCH)).toEqual({});
	});
});
