import fc from "fast-check";
import { describe, expect, it, vi } from "vitest";
import { DragSession } from "../../../../web/src/ui/handles/drag_session";
import { EscapeKey } from "../../../../web/src/ui/handles/escape_key";
import { nearest, type Point } from "../../../../web/src/ui/handles/point";
import { roundLength } from "../../../../web/src/ui/handles/scale_bar";

type Places = Readonly<Record<string, Point>>;

/** Drag session over named places, whose frames the test runs. */
function session(start: Places, alone = false) {
	const view = { places: start, calls: [] as string[], frames: [] as (() => void)[] };
	const drags = new DragSession<string, Places>({
		get: () => view.places,
		place: (name) => view.places[name],
		pull: (places, name, to) => ({ ...places, [name]: to }),
		same: (one, other) => JSON.stringify(one) === JSON.stringify(other),
		alone,
		input: (places) => {
			view.places = places;
			view.calls.push("input");
		},
		change: () => view.calls.push("change"),
		schedule: (callback) => view.frames.push(callback),
	});
	return { view, drags };
}

const START = { a: { x: 1, y: 2 }, b: { x: 5, y: 5 } };

describe("a drag", () => {
	it("begins beside a handle without a jump, and follows the pointer", () => {
		const number = fc.integer({ min: -50, max: 50 });
		fc.assert(
			fc.property(number, number, (x, y) => {
				const { view, drags } = session(START);
				drags.begin(1, "a", { x: 1 + x, y: 2 + y });
				drags.move(1, { x: 1 + x, y: 2 + y });
				drags.end(1);
				expect(view.calls).toEqual([]);
				drags.begin(1, "a", { x: 1 + x, y: 2 + y });
				drags.move(1, { x: 11 + x, y: y - 18 });
				drags.end(1);
				expect(view.places.a).toEqual({ x: 11, y: -18 });
				expect(view.calls).toEqual(["input", "change"]);
			}),
		);
	});

	it("requests one frame at a time, and reports the positions of two fingers together", () => {
		const { view, drags } = session(START);
		drags.begin(1, "a", START.a);
		drags.begin(2, "b", START.b);
		drags.move(1, { x: 3, y: 3 });
		drags.move(2, { x: 7, y: 7 });
		drags.move(1, { x: 4, y: 4 });
		expect(view.frames).toHaveLength(1);
		view.frames[0]();
		expect(view.calls).toEqual(["input"]);
		expect(view.places).toEqual({ a: { x: 4, y: 4 }, b: { x: 7, y: 7 } });
		drags.end(1);
		expect(view.calls).toEqual(["input"]);
		drags.cancel();
		expect(view.calls).toEqual(["input", "input", "change"]);
		expect(view.places).toEqual(START);
	});

	it("rejects a second finger in a view that allows one drag", () => {
		const { drags } = session(START, true);
		expect(drags.begin(1, "a", START.a)).toBe(true);
		expect(drags.begin(2, "b", START.b)).toBe(false);
		drags.end(1);
		expect(drags.begin(2, "b", START.b)).toBe(true);
	});

	it("keeps its changes when dropped, and reports its end", () => {
		const { view, drags } = session(START);
		drags.begin(1, "a", START.a);
		drags.move(1, { x: 2, y: 3 });
		view.frames.shift()?.();
		drags.drop();
		drags.drop();
		expect(view).toMatchObject({ places: { a: { x: 2, y: 3 } }, calls: ["input", "change"] });
		expect(drags.active).toBe(false);
	});

	it("reports nothing when cancelled without movement", () => {
		const { view, drags } = session(START);
		drags.begin(1, "a", START.a);
		drags.cancel();
		drags.cancel();
		expect(view.calls).toEqual([]);
		expect(drags.active).toBe(false);
	});
});

it("picks the nearest handle within reach, or none", () => {
	const places: [string, Point][] = [
		["p2", { x: 0, y: 20 }],
		["p3", { x: 14, y: 10 }],
	];
	expect(nearest(places, { x: 4, y: 18 }, 22)).toBe("p2");
	expect(nearest(places, { x: 10, y: 14 }, 22)).toBe("p3");
	expect(nearest(places, { x: 80, y: 80 }, 22)).toBeUndefined();
	expect(nearest(places, { x: Number.NaN, y: 0 }, 22)).toBeUndefined();
});

it("makes scale bars of round lengths", () => {
	expect([99, 100, 0.049, 7].map(roundLength)).toEqual([50, 100, 0.02, 5]);
});

it("handles Escape while listening, and stops its propagation", () => {
	const page = new EventTarget();
	vi.stubGlobal("window", page);
	const pressed = vi.fn();
	const key = new EscapeKey(pressed);
	const press = (name: string) => {
		const event = Object.assign(new Event("keydown", { cancelable: true }), { key: name, stopPropagation: vi.fn() });
		page.dispatchEvent(event);
		return [event.defaultPrevented, event.stopPropagation.mock.calls.length];
	};
	press("Escape");
	key.listen(true);
	expect(press("a")).toEqual([false, 0]);
	expect(pressed).not.toHaveBeenCalled();
	expect(press("Escape")).toEqual([true, 1]);
	expect(pressed).toHaveBeenCalledTimes(1);
	key.listen(false);
	press("Escape");
	expect(pressed).toHaveBeenCalledTimes(1);
	vi.unstubAllGlobals();
});
