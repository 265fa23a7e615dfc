import { describe, expect, it } from "vitest";
import {
	canRedo,
	canUndo,
	change,
	LONGEST_HISTORY,
	redo,
	type SpecimenHistory,
	settle,
	startHistory,
	undo,
} from "../../../web/src/specimen/history";
import { specimenFromPreset, withParameters } from "../bunch";

const long = (l: number) => withParameters(specimenFromPreset(), { l });
const lengths = (history: SpecimenHistory) =>
	[...history.past, history.present, ...history.future].map(({ parameters }) => parameters.l);

describe("history", () => {
	it("goes back and forth through its steps", () => {
		let history = change(change(startHistory(long(100)), long(200)), long(300));
		history = undo(undo(history));
		expect(history.present).toEqual(long(100));
		expect([canUndo(history), canRedo(history)]).toEqual([false, true]);
		history = redo(redo(history));
		expect(history.present).toEqual(long(300));
		expect([canUndo(history), canRedo(history)]).toEqual([true, false]);
	});

	it("stays at its ends", () => {
		const history = startHistory(long(100));
		expect(undo(history)).toEqual(history);
		expect(redo(history)).toEqual(history);
	});

	it("takes one drag as one step", () => {
		let history = startHistory(long(100));
		for (let l = 101; l <= 150; l++) history = change(history, long(l), "p2");
		history = settle(history);
		for (let l = 149; l >= 120; l--) history = change(history, long(l), "p2");
		expect(lengths(history)).toEqual([100, 150, 120]);
		expect(undo(undo(history)).present).toEqual(long(100));
	});

	it("takes a run of presses as one step, though each comes to rest; another run is another", () => {
		let history = startHistory(long(100));
		for (const l of [101, 102, 103]) history = settle(change(history, long(l), "key", "right"));
		expect(lengths(history)).toEqual([100, 103]);
		history = settle(change(history, long(90), "key", "left"));
		history = settle(change(history, long(91), "drag"));
		history = settle(change(history, long(92), "key", "left"));
		expect(lengths(history)).toEqual([100, 103, 90, 91, 92]);
		history = settle(change(undo(history), long(93), "key", "left"));
		expect(lengths(history)).toEqual([100, 103, 90, 91, 93]);
	});

	it("keeps no step of a run that comes back, and goes on from there", () => {
		let history = startHistory(long(100));
		for (const l of [101, 100, 101, 102]) history = settle(change(history, long(l), "key", "run"));
		expect(lengths(history)).toEqual([100, 102]);
	});

	it("undoes a drag that has not ended, as a whole", () => {
		const history = change(change(startHistory(long(100)), long(110), "p2"), long(120), "p2");
		expect(lengths(undo(history))).toEqual([100, 120]);
		expect(undo(history).present).toEqual(long(100));
	});

	it("keeps no step of a drag that ended where it began, nor of a change that changes nothing", () => {
		let history = change(startHistory(long(100)), long(200));
		history = settle(change(change(history, long(210), "p2"), long(200), "p2"));
		history = change(history, long(200));
		expect(lengths(history)).toEqual([100, 200]);
	});

	it("keeps what was undone through a drag that ends where it began, and forgets it through one that does not", () => {
		const undone = undo(change(startHistory(long(100)), long(200)));
		const away = change(change(undone, long(110), "p2"), long(120), "p2");
		expect([canUndo(away), canRedo(away)]).toEqual([true, false]);
		const back = change(away, long(100), "p2");
		expect([canUndo(back), canRedo(back)]).toEqual([false, true]);
		expect(settle(back)).toEqual(undone);
		expect(redo(back).present).toEqual(long(200));
		expect(lengths(settle(away))).toEqual([100, 120]);
		expect(redo(away).present).toEqual(long(120));
	});

	it("makes two steps of two drags in a row, though nobody ended the first", () => {
		const history = change(change(startHistory(long(100)), long(110), "p2"), long(120), "p3");
		expect(lengths(settle(history))).toEqual([100, 110, 120]);
	});

	it("forgets what was undone when something new is done", () => {
		const history = change(undo(change(startHistory(long(100)), long(200))), long(300));
		expect(lengths(history)).toEqual([100, 300]);
		expect(canRedo(history)).toBe(false);
	});

	it("forgets its oldest steps", () => {
		let history = startHistory(long(30));
		for (let step = 1; step <= LONGEST_HISTORY + 5; step++) history = change(history, long(30 + step));
		expect(history.past).toHaveLength(LONGEST_HISTORY);
		expect(history.past[0]).toEqual(long(35));
	});

	it("never changes a history that it was given", () => {
		const before = change(change(startHistory(long(100)), long(200)), long(300));
		const copy = structuredClone(before);
		for (const act of [undo, redo, settle, (h: SpecimenHistory) => change(h, long(50))]) act(before);
		expect(before).toEqual(copy);
	});
});
