import { beforeEach, describe, expect, it, vi } from "vitest";
import { ASKING, askFor, heldAims } from "../../../web/src/app/asking";
import type { Studio } from "../../../web/src/app/studio";
import { MOST_GROWTHS } from "../../../web/src/targets/solve";
import { BUNCH, type Specimen, specimenFromPreset } from "../bunch";
import { studioWith } from "./context";

const KEYS = BUNCH.table.measures.map(({ key }) => key);

/** A plant that is as long as `l` says, and as wide as its widest side. */
function measured({ parameters }: Specimen): Float32Array {
	const values = new Float32Array(KEYS.length).fill(Number.NaN);
	values[KEYS.indexOf("bunch_length")] = 0.4 * parameters.l;
	values[KEYS.indexOf("bunch_width")] = Math.max(parameters.p3w, parameters.p4w) + 0.05 * parameters.l;
	return values;
}

let studio: Studio;
let surroundings: Awaited<ReturnType<typeof studioWith>>["surroundings"];
beforeEach(async () => {
	({ studio, surroundings } = await studioWith(specimenFromPreset("riesling")));
	surroundings.measure.mockImplementation(async (_, specimen) => measured(specimen as Specimen));
});

const length = () => studio.state.specimen.parameters.l;
const notices = () => studio.state.notices.map(({ title, details }) => [title, ...details].join(" | "));

describe("asking for a number", () => {
	it("takes what was found as one step, and says so", async () => {
		const before = studio.state.specimen;
		await askFor(studio, { measure: "bunch_length", value: 160 });
		expect(length()).toBeCloseTo(400, -1);
		expect(notices()).toEqual([expect.stringMatching(/^Bunch length: 160 mm reached \| Length .* in \d growths\.$/)]);
		expect(studio.toolState(ASKING).now).toBeUndefined();
		studio.undo();
		expect(studio.state.specimen).toBe(before);
		expect(notices()).toEqual([]);
	});

	it("holds what was asked before, until something else changes", async () => {
		await askFor(studio, { measure: "bunch_length", value: 160 });
		await askFor(studio, { measure: "bunch_width", value: 90 });
		expect(heldAims(studio)).toEqual([
			{ measure: "bunch_length", value: 160 },
			{ measure: "bunch_width", value: 90 },
		]);
		const values = measured(studio.state.specimen as Specimen);
		expect(values[KEYS.indexOf("bunch_length")]).toBeCloseTo(160, 0);
		expect(values[KEYS.indexOf("bunch_width")]).toBeCloseTo(90, 0);
		expect(notices()).toEqual([expect.stringMatching(/^Bunch width: 90 mm reached \| Bunch length: 160 mm reached/)]);
		studio.set({ parameters: { density: 3 } });
		expect(heldAims(studio)).toEqual([]);
	});

	it("says how far it is, and ends when told to, the document as it was", async () => {
		const before = studio.state.specimen;
		const growths: number[] = [];
		surroundings.measure.mockImplementation(async () => {
			const { now } = studio.toolState(ASKING);
			growths.push(now?.growths ?? -1);
			if (growths.length === 3) now?.cancel();
			return new Float32Array(KEYS.length).fill(growths.length);
		});
		await askFor(studio, { measure: "bunch_length", value: 160 });
		expect(growths).toEqual([0, 1, 2]);
		expect(growths.length).toBeLessThan(MOST_GROWTHS);
		expect(studio.state.specimen).toBe(before);
		expect(studio.toolState(ASKING)).toEqual({});
		expect(notices()).toEqual([]);
	});

	it("gives way to a hand that changes the plant meanwhile", async () => {
		surroundings.measure.mockImplementation(async (_, specimen) => {
			studio.edit({ parameters: { density: 2 } });
			return measured(specimen as Specimen);
		});
		await askFor(studio, { measure: "bunch_length", value: 160 });
		expect(surroundings.measure).toHaveBeenCalledTimes(1);
		expect(studio.state.specimen.parameters).toMatchObject({
			density: 2,
			l: specimenFromPreset("riesling").parameters.l,
		});
	});

	it("holds what was found though a search after it is cancelled", async () => {
		await askFor(studio, { measure: "bunch_length", value: 160 });
		surroundings.measure.mockImplementation(async () => {
			studio.toolState(ASKING).now?.cancel();
			throw new Error("cancelled");
		});
		await askFor(studio, { measure: "bunch_width", value: 90 });
		expect(studio.toolState(ASKING).now).toBeUndefined();
		expect(heldAims(studio)).toEqual([{ measure: "bunch_length", value: 160 }]);
	});

	it("leaves the progress of the search that took its place", async () => {
		const waiting: ((values: Float32Array) => void)[] = [];
		surroundings.measure.mockImplementation(() => new Promise((resolve) => waiting.push(resolve)));
		const first = askFor(studio, { measure: "bunch_length", value: 160 });
		await vi.waitFor(() => expect(waiting).toHaveLength(1));
		const second = askFor(studio, { measure: "bunch_width", value: 90 });
		waiting[0](new Float32Array(KEYS.length).fill(3));
		await first;
		expect(studio.toolState(ASKING).now).toMatchObject({ measure: "bunch_width" });
		await vi.waitFor(() => expect(waiting).toHaveLength(2));
		studio.toolState(ASKING).now?.cancel();
		waiting[1](new Float32Array(KEYS.length).fill(3));
		await second;
		expect(studio.toolState(ASKING)).toEqual({});
	});

	it("says what went wrong", async () => {
		surroundings.measure.mockRejectedValue(new Error("no core"));
		await askFor(studio, { measure: "bunch_length", value: 160 });
		expect(notices()).toEqual(["What was asked for could not be looked for | no core"]);
		expect(studio.toolState(ASKING)).toEqual({});
	});
});
