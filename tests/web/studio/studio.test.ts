import { beforeEach, describe, expect, it, vi } from "vitest";
import type { Grown } from "../../../web/src/models/bunch/grown";
import { specimenFromPreset } from "../../../web/src/specimen/from_preset";
import type { Specimen } from "../../../web/src/specimen/specimen";
import { PLAY, Studio } from "../../../web/src/studio/studio";
import { FIRST_VISIT } from "../../../web/src/studio/ui_state";

const opened = specimenFromPreset("grape-15c");

describe("the studio", () => {
	const surroundings = { grow: vi.fn(), cancel: vi.fn(), settled: vi.fn(), remember: vi.fn() };
	let studio: Studio;
	const grownLast = () => surroundings.grow.mock.lastCall?.[0] as Specimen;
	const length = () => studio.state.specimen.parameters.l;

	beforeEach(() => {
		vi.clearAllMocks();
		studio = new Studio(opened, FIRST_VISIT, surroundings);
	});

	it("grows at every step of a drag, but makes one undo step and one address of it", () => {
		for (const l of [400, 390, 380]) studio.edit({ parameters: { l } });
		expect(surroundings.grow).toHaveBeenCalledTimes(3);
		expect(surroundings.grow).toHaveBeenLastCalledWith(studio.state.specimen, { measures: false });
		expect(surroundings.settled).not.toHaveBeenCalled();
		studio.settle();
		expect(surroundings.settled).toHaveBeenCalledExactlyOnceWith(studio.state.specimen);
		studio.undo();
		expect(studio.state.specimen).toEqual(opened);
		expect(grownLast()).toEqual(opened);
		studio.redo();
		expect(length()).toBe(380);
	});

	it("measures what is at rest: once after a drag, wherever it ended, and with every step of its own", () => {
		studio.edit({ parameters: { l: 400 } });
		studio.settle();
		expect(surroundings.grow).toHaveBeenCalledTimes(2);
		expect(surroundings.grow).toHaveBeenLastCalledWith(studio.state.specimen, { measures: true });
		studio.settle();
		expect(surroundings.grow).toHaveBeenCalledTimes(2);
		studio.edit({ parameters: { l: 300 } });
		studio.edit({ parameters: { l: 400 } });
		studio.settle();
		expect(surroundings.grow.mock.lastCall?.[1]).toEqual({ measures: true });
		surroundings.grow.mockClear();
		studio.set({ parameters: { l: 390 } });
		expect(surroundings.grow).toHaveBeenCalledExactlyOnceWith(studio.state.specimen, { measures: true });
	});

	it("keeps what was last measured while a drag asks for nothing", () => {
		const measures = Float32Array.of(1, 2);
		studio.grew({ measures } as Grown, opened);
		studio.grew({} as Grown, opened);
		expect(studio.state.measures).toBe(measures);
	});

	it("takes berries off by hand, one step each, and puts them all back as one", () => {
		studio.thin(7, 9);
		expect(studio.state.marked).toBe(9);
		studio.thin(3);
		expect(studio.state.specimen.thinned).toEqual([7, 3]);
		expect(grownLast().thinned).toEqual([7, 3]);
		studio.putBack();
		expect(studio.state.specimen.thinned).toEqual([]);
		studio.undo();
		expect(studio.state.specimen.thinned).toEqual([7, 3]);
		studio.undo();
		expect(studio.state.specimen.thinned).toEqual([7]);
		expect(surroundings.settled.mock.lastCall?.[0].thinned).toEqual([7]);
	});

	it("makes a play one step, and a drag meanwhile another", () => {
		studio.setPlaying(true);
		for (const age of [10, 20]) studio.edit({ parameters: { age } }, PLAY);
		studio.edit({ parameters: { l: 300 } });
		studio.setPlaying(false);
		expect(studio.state.history.gesture).toBeDefined();
		studio.settle();
		expect(studio.state.history.past).toHaveLength(2);
		studio.undo();
		expect(studio.state.specimen.parameters).toMatchObject({ l: opened.parameters.l, age: 20 });
	});

	it("makes a step of every drag", () => {
		studio.set({ parameters: { l: 400 } });
		studio.set({ parameters: { l: 300 } });
		studio.undo();
		expect(length()).toBe(400);
		expect(surroundings.settled.mock.lastCall?.[0].parameters.l).toBe(400);
	});

	it("leaves no step where a drag ends where it began", () => {
		studio.edit({ parameters: { l: 400 } });
		studio.edit({ parameters: { l: opened.parameters.l } });
		studio.settle();
		expect(studio.state.history.past).toHaveLength(0);
	});

	it("does not grow for a colour, but draws and remembers it", () => {
		const listener = vi.fn();
		studio.subscribe(listener);
		studio.set({ look: { skin: "ffffff" } });
		expect(surroundings.grow).not.toHaveBeenCalled();
		expect(listener).toHaveBeenCalled();
		expect(surroundings.settled).toHaveBeenCalled();
	});

	it("says which parts of a link could not be used, once, until dismissed", () => {
		const notes = [{ key: "l", problem: "", text: "l: too long." }];
		studio.take({ specimen: specimenFromPreset("lychee"), notes }, "link");
		studio.take({ specimen: specimenFromPreset("lychee"), notes }, "link");
		expect(studio.state.notices).toMatchObject([
			{ title: "Not everything in the link could be used", details: ["l: too long."] },
		]);
		studio.dismiss(studio.state.notices[0].id);
		expect(studio.state.notices).toHaveLength(0);
	});

	it("opens with a document as the first of its history, grown and in the address, and with its notes", () => {
		const grammar = { ...specimenFromPreset("lychee"), grammar: "axiom: F" };
		studio.open({ specimen: grammar, notes: [{ key: "l", problem: "", text: "l: too long." }] }, "link");
		expect(studio.state.specimen).toEqual(grammar);
		expect(studio.state.history).toEqual({ past: [], present: grammar, future: [] });
		expect(surroundings.grow).toHaveBeenCalledExactlyOnceWith(grammar, { measures: true });
		expect(surroundings.settled).toHaveBeenCalledExactlyOnceWith(grammar);
		expect(studio.state.notices).toMatchObject([{ details: ["l: too long."] }]);
	});

	it("goes to the published preset, seed and all, and back", () => {
		studio.newVariation();
		studio.choosePreset("duku");
		expect(studio.state.specimen).toEqual(specimenFromPreset("duku"));
		studio.undo();
		studio.reset();
		expect(studio.state.specimen).toEqual(opened);
	});

	it("brings locked sides together at once and undoes that as one step", () => {
		studio.toggleLock("leftRight");
		const { p3w, p4w } = studio.state.specimen.parameters;
		expect(p4w).toBe(p3w);
		studio.edit({ parameters: { p3w: 111 } });
		expect(studio.state.specimen.parameters.p4w).toBe(111);
		studio.settle();
		studio.undo();
		studio.undo();
		expect(studio.state.specimen).toEqual(opened);
		expect(studio.state.ui.locks.leftRight).toBe(true);
	});

	it.each([
		["leftRight", "p3", "p4"],
		["frontBack", "p5", "p6"],
	] as const)("mirrors %s as one step, locked or not", (pair, a, b) => {
		studio.setUi({ locks: { leftRight: true, frontBack: true } });
		const { parameters } = opened;
		studio.mirror(pair);
		expect(studio.state.specimen.parameters).toEqual({
			...parameters,
			[`${a}w`]: parameters[`${b}w`],
			[`${a}r`]: parameters[`${b}r`],
			[`${b}w`]: parameters[`${a}w`],
			[`${b}r`]: parameters[`${a}r`],
		});
		studio.undo();
		expect(studio.state.specimen).toEqual(opened);
	});

	it("switches to the paper's letter and back to what was before", () => {
		studio.set({ parameters: { vary: 0.7 } });
		studio.setAsPrinted(true);
		expect(studio.state.specimen.parameters).toMatchObject({ fit: 0, vary: 0 });
		studio.setAsPrinted(false);
		expect(studio.state.specimen.parameters).toMatchObject({ fit: 1, vary: 0.7 });
	});

	it("remembers which groups are closed, and tells each change once", () => {
		studio.setGroup("shape", false);
		studio.setGroup("shape", false);
		expect(surroundings.remember).toHaveBeenCalledOnce();
		expect(studio.state.ui.closed).toContain("shape");
		studio.setGroup("shape", true);
		expect(studio.state.ui.closed).not.toContain("shape");
	});
});
