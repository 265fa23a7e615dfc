import { describe, expect, it } from "vitest";
import { profileDrags } from "../../../../../web/src/models/bunch/profile/drag_session";
import type { BunchShape, Handle, Locks } from "../../../../../web/src/models/bunch/profile/handles";
import { DEFAULTS } from "./shape";

/** A view that records its events, with frames that the test triggers. */
function view(handles: Handle[] = ["p2", "p3", "p4"], locks: Locks = { leftRight: false, frontBack: false }) {
	const received: [what: string, shape: BunchShape][] = [];
	let frame: (() => void) | undefined;
	const page = {
		parameters: { ...DEFAULTS } as BunchShape,
		received,
		frame() {
			const callback = frame;
			frame = undefined;
			callback?.();
		},
		waiting: () => frame !== undefined,
	};
	const drags = profileDrags<BunchShape>({
		handles: () => handles,
		locks: () => locks,
		get: () => page.parameters,
		input: (parameters) => {
			page.parameters = parameters;
			received.push(["input", parameters]);
		},
		change: () => received.push(["change", page.parameters]),
		schedule: (callback) => {
			expect(frame).toBeUndefined();
			frame = callback;
		},
	});
	return { page, drags };
}

const events = (received: [string, BunchShape][]) => received.map(([what]) => what);

describe("a drag", () => {
	it("reports the newest position once a frame, and once at its end", () => {
		const { page, drags } = view();
		drags.begin(1, "p3", { x: 150, y: 150 });
		for (let x = 151; x <= 170; x++) drags.move(1, { x, y: 150 });
		expect(page.received).toEqual([]);
		page.frame();
		drags.move(1, { x: 180, y: 160 });
		page.frame();
		drags.end(1);
		expect(events(page.received)).toEqual(["input", "input", "change"]);
		expect(page.received[0][1].p3w).toBe(170);
		expect(page.parameters).toEqual({ ...DEFAULTS, p3w: 180, p3r: 160 });
	});

	it("applies the last position before it ends", () => {
		const { page, drags } = view();
		drags.begin(1, "p2", { x: 3, y: 515 });
		drags.move(1, { x: 9, y: 415 });
		drags.end(1);
		expect(events(page.received)).toEqual(["input", "change"]);
		expect(page.parameters.l).toBe(412);
		page.frame();
		expect(page.received).toHaveLength(2);
	});

	it("that changes nothing is not reported: a click is no undo step", () => {
		const { page, drags } = view();
		drags.begin(1, "p3", { x: 160, y: 140 });
		drags.move(1, { x: 190, y: 140 });
		drags.move(1, { x: 160, y: 140 });
		drags.end(1);
		expect(page.received).toEqual([]);
	});

	it("that ends where it began reports its end once", () => {
		const { page, drags } = view();
		drags.begin(1, "p3", { x: 150, y: 150 });
		drags.move(1, { x: 190, y: 140 });
		page.frame();
		drags.move(1, { x: 150, y: 150 });
		drags.end(1);
		expect(events(page.received)).toEqual(["input", "input", "change"]);
		expect(page.parameters).toEqual(DEFAULTS);
		drags.begin(1, "p3", { x: 150, y: 150 });
		drags.end(1);
		expect(page.received).toHaveLength(3);
	});

	it("leaves a fractional profile alone until it is moved", () => {
		const { page, drags } = view();
		page.parameters = { ...DEFAULTS, p3w: 150.25 };
		drags.begin(1, "p3", { x: 150, y: 150 });
		drags.end(1);
		expect(page.received).toEqual([]);
	});

	it("restores the original when cancelled, and reports nothing afterwards", () => {
		const { page, drags } = view();
		drags.begin(1, "p3", { x: 150, y: 150 });
		drags.move(1, { x: 250, y: 50 });
		page.frame();
		drags.move(1, { x: 260, y: 40 });
		drags.cancel();
		expect(page.parameters).toEqual(DEFAULTS);
		page.frame();
		drags.move(1, { x: 10, y: 10 });
		drags.end(1);
		expect(events(page.received)).toEqual(["input", "input", "change"]);
		expect(drags.active).toBe(false);
	});

	it("of two fingers restores the state before the first of them when cancelled", () => {
		const { page, drags } = view();
		drags.begin(1, "p3", { x: 150, y: 150 });
		drags.move(1, { x: 200, y: 150 });
		page.frame();
		drags.begin(2, "p4", { x: -150, y: 102 });
		drags.move(2, { x: -100, y: 102 });
		page.frame();
		expect(page.parameters).toMatchObject({ p3w: 200, p4w: 100 });
		drags.cancel();
		expect(page.parameters).toEqual(DEFAULTS);
	});

	it("keeps changes of another view when cancelled", () => {
		const { page, drags } = view(["p2", "p3", "p4"]);
		drags.begin(1, "p3", { x: 150, y: 150 });
		drags.move(1, { x: 250, y: 50 });
		page.frame();
		page.parameters = { ...page.parameters, p5w: 33 };
		drags.cancel();
		expect(page.parameters).toEqual({ ...DEFAULTS, p5w: 33 });
	});

	it("carries its locks and its straight line", () => {
		const { page, drags } = view(undefined, { leftRight: true, frontBack: false });
		drags.begin(1, "p4", { x: -150, y: 102 });
		drags.move(1, { x: -100, y: 110 }, { shiftKey: true, altKey: false });
		drags.end(1);
		expect(page.parameters).toEqual({ ...DEFAULTS, p4w: 100, p3w: 100, p3r: 102 });
	});
});

describe("two fingers", () => {
	it("drag two handles; the change is reported when the last is released", () => {
		const { page, drags } = view();
		expect(drags.begin(1, "p3", { x: 150, y: 150 })).toBe(true);
		expect(drags.begin(2, "p4", { x: -150, y: 102 })).toBe(true);
		drags.move(1, { x: 170, y: 150 });
		drags.move(2, { x: -130, y: 102 });
		page.frame();
		drags.end(1);
		expect(drags.holds("p3")).toBe(false);
		expect(drags.heldBy(2)).toBe("p4");
		drags.move(2, { x: -120, y: 102 });
		drags.end(2);
		expect(events(page.received)).toEqual(["input", "input", "change"]);
		expect(page.parameters).toEqual({ ...DEFAULTS, p3w: 170, p4w: 120 });
	});

	it("cannot take the same handle, nor one finger two", () => {
		const { drags } = view();
		drags.begin(1, "p3", { x: 150, y: 150 });
		expect(drags.begin(2, "p3", { x: 150, y: 150 })).toBe(false);
		expect(drags.begin(1, "p4", { x: -150, y: 102 })).toBe(false);
	});

	it("in two views do not undo each other: a target is applied to the parameters of its frame", () => {
		const { page, drags } = view();
		drags.begin(1, "p3", { x: 150, y: 150 });
		drags.move(1, { x: 200, y: 150 });
		page.parameters = { ...page.parameters, p5w: 33 };
		page.frame();
		expect(page.parameters).toEqual({ ...DEFAULTS, p3w: 200, p5w: 33 });
	});
});
