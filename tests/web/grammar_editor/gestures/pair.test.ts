import { describe, expect, it } from "vitest";
import { type Axis, atShare, shareOf } from "../../../../web/src/grammar_editor/gestures/axis";
import { pushOf } from "../../../../web/src/grammar_editor/gestures/gamepad_driver";
import { nextPair, pairOf } from "../../../../web/src/grammar_editor/gestures/pair";

const axis = (id: string, min = 0, max = 1, value = 0): Axis => ({
	id,
	label: id,
	read: String(value),
	min,
	max,
	step: 0.1,
	value,
});
const ids = ({ across, up }: { across?: Axis; up?: Axis }) => [across?.id, up?.id];
const none = { across: undefined, up: undefined };

describe("the pair of controlled numbers", () => {
	const axes = ["constant scale", "constant length", "constant bend", "parameter age", "parameter open"].map((id) =>
		axis(id),
	);

	it("defaults to the bend and the length of the stem", () => {
		expect(ids(pairOf(axes, none))).toEqual(["constant bend", "constant length"]);
		expect(ids(pairOf(axes.slice(3), none))).toEqual(["parameter age", "parameter open"]);
		expect(ids(pairOf(axes.slice(0, 2), none))).toEqual(["constant scale", "constant length"]);
		expect(ids(pairOf([], none))).toEqual([undefined, undefined]);
	});

	it("keeps the requested numbers that exist", () => {
		expect(ids(pairOf(axes, { across: "parameter age", up: "gone" }))).toEqual(["parameter age", "constant length"]);
	});

	it("advances to the next two, cyclically", () => {
		const next = nextPair(axes, { across: "constant bend", up: "constant length" });
		expect(next).toEqual({ across: "parameter age", up: "parameter open" });
		expect(nextPair(axes, next)).toEqual({ across: "constant scale", up: "constant length" });
		expect(nextPair(axes.slice(0, 1), none)).toEqual(none);
	});

	it("go linearly from end to end (Petrenko 2014, section 4.3.3)", () => {
		const bend = axis("constant bend", -5, 5, 2.5);
		expect(shareOf(bend)).toBe(0.75);
		expect([0, 0.5, 1, 7].map((share) => atShare(bend, share))).toEqual([-5, 0, 5, 5]);
	});
});

it("a gamepad moves by its stick and its directional pad, with a dead zone", () => {
	const buttons = (...pressed: number[]) => Array.from({ length: 16 }, (_, i) => ({ pressed: pressed.includes(i) }));
	expect(pushOf({ axes: [0.1, -0.14], buttons: [] })).toEqual({ x: 0, y: 0 });
	expect(pushOf({ axes: [1, -1], buttons: [] })).toEqual({ x: 1, y: -1 });
	expect(pushOf({ axes: [0, 0], buttons: buttons(13, 14) })).toEqual({ x: -1, y: 1 });
	expect(pushOf({ axes: [1, 0], buttons: buttons(15) }).x).toBe(1);
	expect(pushOf({ axes: [0.575, 0], buttons: buttons() }).x).toBeCloseTo(0.5);
});
