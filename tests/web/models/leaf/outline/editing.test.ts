import { describe, expect, it } from "vitest";
import { bundled } from "../../../../../web/src/models/leaf/outline/bundles";
import { type FlatVeins, inkOutline, type LeafPen } from "../../../../../web/src/models/leaf/outline/outline_canvas";
import { outlineDrags } from "../../../../../web/src/models/leaf/outline/outline_drag";
import {
	fittedFrame,
	inReach,
	inView,
	onLeaf,
	scaleBar,
	steadyFrame,
} from "../../../../../web/src/models/leaf/outline/outline_frame";
import { pointInWords } from "../../../../../web/src/models/leaf/outline/outline_words";
import { MAX_POINTS, movePoint, type OutlinePoints } from "../../../../../web/src/models/leaf/outline/points";
import { curveOf } from "../../../../../web/src/models/leaf/outline/spline";
import { inserted, pressed } from "../../../../../web/src/models/leaf/outline/steps";
import { leafFromPreset } from "../../../../../web/src/models/leaf/schema";

const { outline: oak } = leafFromPreset("oak");
const SAME = { mirror: true };
const key = (name: string, shiftKey = false) => ({ key: name, shiftKey });

/** A drag over an outline that records its events. */
function dragOver(points: OutlinePoints) {
	const events: string[] = [];
	const state = { points, events, waiting: [] as (() => void)[] };
	const drag = outlineDrags({
		get: () => state.points,
		symmetry: () => SAME,
		input: (next) => {
			events.push("input");
			state.points = next;
		},
		change: () => events.push("change"),
		refused: () => events.push("refused"),
		schedule: (callback) => state.waiting.push(callback),
	});
	const frame = () => {
		for (const callback of state.waiting.splice(0)) callback();
	};
	return { drag, state, frame };
}

describe("a drag", () => {
	it("dispatches at most one event per frame, keeps the grab offset, and ends as one change", () => {
		const { drag, state, frame } = dragOver(oak);
		const { x, y } = oak[5];
		expect(drag.begin(1, "5", { x: x + 0.01, y })).toBe(true);
		drag.move(1, { x: x + 0.02, y });
		drag.move(1, { x: x + 0.03, y });
		expect(state.events).toEqual([]);
		frame();
		expect(state.events).toEqual(["input"]);
		expect(state.points[5].x).toBeCloseTo(x + 0.02, 3);
		expect(state.points[oak.length - 5].x).toBeCloseTo(-x - 0.02, 3);
		drag.end(1);
		expect(state.events).toEqual(["input", "change"]);
		expect(drag.active).toBe(false);
	});

	it("stops where the outline would cross itself, with one event each time", () => {
		const { drag, state, frame } = dragOver(oak);
		drag.begin(1, "10", oak[10]);
		drag.move(1, { x: -0.5, y: 0.3 });
		frame();
		drag.move(1, { x: -0.5, y: 0.31 });
		frame();
		expect(state.points).toEqual(oak);
		expect(state.events).toEqual(["refused"]);
		drag.move(1, { x: oak[10].x, y: oak[10].y + 0.01 });
		frame();
		drag.move(1, { x: -0.5, y: 0.3 });
		frame();
		expect(state.events).toEqual(["refused", "input", "refused"]);
		expect(state.points[10].y).toBeCloseTo(oak[10].y + 0.01, 3);
	});

	it("puts everything back when it is called off", () => {
		const { drag, state, frame } = dragOver(oak);
		drag.begin(1, "5", oak[5]);
		drag.begin(2, "12", oak[12]);
		expect(drag.begin(3, "12", oak[12])).toBe(false);
		drag.move(1, { x: 0.25, y: 0.2 });
		frame();
		expect(state.points).not.toEqual(oak);
		drag.cancel();
		expect(state.points).toEqual(oak);
		expect(state.events).toEqual(["input", "input", "change"]);
		expect(drag.active).toBe(false);
	});
});

describe("a key", () => {
	it("moves the chosen point by a step, by ten with Shift, and announces its position", () => {
		const step = pressed(oak, 6, key("ArrowRight"), SAME);
		expect(step?.points?.[6].x).toBeCloseTo(oak[6].x + 0.005, 3);
		expect(step?.message).toBe("19.1 % right, 22.2 % up");
		expect(pressed(oak, 6, key("ArrowUp", true), SAME)?.points?.[6].y).toBeCloseTo(oak[6].y + 0.05, 3);
	});

	it("that is refused leaves the choice where it is", () => {
		expect(inserted(oak, 6, SAME, { x: -0.5, y: 0.3 })).toEqual({ message: "The outline would cross itself" });
		const full = Array.from({ length: MAX_POINTS }, (_, i) => oak[i % oak.length]);
		expect(inserted(full, 6, SAME)).toEqual({ message: "There is no room for more points" });
	});

	it("goes round the points, adds, removes, and turns them", () => {
		expect(pressed(oak, 1, key("PageUp"), SAME)?.chosen).toBe(oak.length - 1);
		expect(pressed(oak, oak.length - 1, key("PageDown"), SAME)?.chosen).toBe(1);
		const added = pressed(oak, 40, key("Insert"), SAME);
		expect(added?.points).toHaveLength(oak.length + 2);
		expect(added?.points?.[added.chosen ?? 0].x).toBeLessThan(0);
		expect(pressed(oak, 6, key("Delete"), SAME)?.points).toHaveLength(oak.length - 2);
		expect(pressed(oak, 5, key("t"), SAME)).toMatchObject({ message: "corner", chosen: 5 });
		expect(pressed(oak, 5, key("x"), SAME)).toBeUndefined();
	});

	it("does nothing after which there would be no blade", () => {
		const narrow = movePoint(oak, 3, { x: 0.006, y: 0.07 }, SAME);
		const step = pressed(narrow, 3, key("ArrowLeft", true), SAME);
		expect(step).toEqual({ message: "The outline would cross itself" });
	});

	it("has words for a point", () => {
		expect(pointInWords(oak, 6)).toBe("Point 6 of 49, rounded lobe tip: 18.6 % right, 22.2 % up");
		expect(pointInWords(oak, 25)).toBe("Point 25 of 49, rounded lobe tip: in the middle, 100 % up");
	});
});

describe("the view", () => {
	const size = { width: 240, height: 320 };
	const frame = fittedFrame(curveOf(oak), size.width, size.height);

	it("holds the whole leaf, tip up, and knows the place under a pointer", () => {
		for (const place of curveOf(oak)) {
			const { x, y } = inView(frame, place);
			expect(x > 10 && x < 230 && y > 10 && y < 290).toBe(true);
			const back = onLeaf(frame, { x, y });
			expect(back.x).toBeCloseTo(place.x);
			expect(back.y).toBeCloseTo(place.y);
		}
		expect(inView(frame, { x: 0, y: 1 }).y).toBeLessThan(inView(frame, { x: 0, y: 0 }).y);
	});

	it("stays in a drag and after a small one, and follows another leaf", () => {
		const nudged = curveOf(movePoint(oak, 18, { x: 0.36, y: 0.67 }, SAME));
		expect(steadyFrame(frame, nudged, size, false)).toBe(frame);
		const wide = curveOf(leafFromPreset("maple").outline);
		expect(steadyFrame(frame, nudged, size, true)).toBe(frame);
		expect(steadyFrame(frame, wide, size, false).scale).toBeLessThan(frame.scale);
		expect(steadyFrame(frame, nudged, { width: 200, height: 320 }, true)).not.toBe(frame);
	});

	it("goes back from a lobe in hand as far as the whole leaf needs, and no point is taken far out of it", () => {
		const wide = curveOf(leafFromPreset("maple").outline);
		const back = steadyFrame(frame, wide, size, true);
		expect(back.centre).toEqual(frame.centre);
		const [xs, ys] = (["x", "y"] as const).map((axis) => wide.map((place) => inView(back, place)[axis]));
		expect(Math.min(...xs)).toBeGreaterThanOrEqual(5.9);
		expect(Math.max(...xs)).toBeLessThanOrEqual(size.width - 5.9);
		expect(Math.min(...ys)).toBeGreaterThanOrEqual(5.9);
		expect(Math.max(...ys)).toBeLessThanOrEqual(size.height - 19.9);
		expect(steadyFrame(back, wide, size, true)).toBe(back);
		const inside = { x: 0.1, y: 0.5 };
		expect(inReach(back, inside).x).toBeCloseTo(0.1, 9);
		const far = inView(back, inReach(back, { x: 9, y: -9 }));
		expect([far.x, far.y].map(Math.round)).toEqual([size.width - 3, size.height - 17]);
	});

	it("has a scale bar of a round length", () => {
		const { length, label } = scaleBar({ ...frame, scale: 200 }, 100);
		expect([label, length]).toEqual(["2 cm", 40]);
	});
});

describe("the canvas", () => {
	it("gathers veins of like width", () => {
		expect(bundled([1, 1.01, 8, 0.1], 4)).toEqual([[3], [0, 1], [2]]);
		expect(bundled([2, 2], 4)).toEqual([[0, 1]]);
		expect(bundled([], 4)).toEqual([]);
	});

	it("draws every vein, thicker ones with more ink", () => {
		const strokes: { width: number; alpha: number; lines: number }[] = [];
		let lines = 0;
		const state = { lineWidth: 1, globalAlpha: 1 };
		const pen = new Proxy(state as unknown as LeafPen, {
			get: (target, name) => {
				if (name in target) return Reflect.get(target, name);
				return () => {
					if (name === "beginPath") lines = 0;
					if (name === "lineTo") lines++;
					if (name === "stroke") strokes.push({ width: state.lineWidth, alpha: state.globalAlpha, lines });
				};
			},
		});
		const veins: FlatVeins = {
			ends: Float32Array.of(0, 0, 0, 0.5, 0, 0.5, 0, 1, 0, 0.5, 0.2, 0.6),
			widths: Float32Array.of(0.02, 0.02, 0.0001),
			margin: new Float32Array(0),
		};
		inkOutline(pen, { curve: curveOf(oak), veins, frame: fittedFrame(curveOf(oak), 240, 320), ratio: 2, ink: "#000" });
		const [fine, thick] = strokes;
		expect([fine.lines, thick.lines]).toEqual([1, 2]);
		expect(thick.width).toBeGreaterThan(fine.width);
		expect(thick.alpha).toBeGreaterThan(fine.alpha);
	});
});
