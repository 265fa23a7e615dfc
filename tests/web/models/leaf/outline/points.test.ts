import fc from "fast-check";
import { describe, expect, it } from "vitest";
import { packOutline, unpackOutline } from "../../../../../web/src/models/leaf/outline/packed";
import {
	bothSides,
	FEWEST_POINTS,
	insertedAt,
	insertPoint,
	isSymmetric,
	KINDS,
	MAX_POINTS,
	madeSymmetric,
	mirrorOf,
	movePoint,
	type OutlinePoint,
	placed,
	REACH,
	removePoint,
	turnKind,
} from "../../../../../web/src/models/leaf/outline/points";
import { curveOf, enclosesBlade, nearestSpan, spansOf } from "../../../../../web/src/models/leaf/outline/spline";
import { LEAF, leafFromPreset } from "../../../../../web/src/models/leaf/schema";

const { outline: oak } = leafFromPreset("oak");
const [SAME, ALONE] = [{ mirror: true }, { mirror: false }];
/** Four points: base, right, tip, left. */
const kite: OutlinePoint[] = [
	{ x: 0, y: 0, kind: "corner" },
	{ x: 0.3, y: 0.4, kind: "smooth" },
	{ x: 0, y: 1, kind: "pointed" },
	{ x: -0.3, y: 0.4, kind: "smooth" },
];

const arbitraryPoint = fc
	.record({
		x: fc.double({ min: REACH.x[0], max: REACH.x[1], noNaN: true }),
		y: fc.double({ min: REACH.y[0], max: REACH.y[1], noNaN: true }),
		kind: fc.constantFrom(...KINDS),
	})
	.map((point) => ({ ...placed(point), kind: point.kind }));

describe("editing an outline", () => {
	it("move a point, and with the lock its like at the other side", () => {
		expect(movePoint(kite, 1, { x: 0.35, y: 0.5 }, ALONE)[3]).toEqual(kite[3]);
		const moved = movePoint(kite, 1, { x: 0.35, y: 0.5 }, SAME);
		expect([moved[1].x, moved[1].y, moved[3].x, moved[3].y]).toEqual([0.35, 0.5, -0.35, 0.5]);
		expect(isSymmetric(moved)).toBe(true);
	});

	it("keep a locked tip in the middle, the base where it is, and every point in reach", () => {
		expect(movePoint(kite, 2, { x: 0.2, y: 1.1 }, SAME)[2]).toEqual({ x: 0, y: 1.1, kind: "pointed" });
		expect(movePoint(kite, 2, { x: 0.2, y: 1.1 }, ALONE)[2].x).toBe(0.2);
		expect(movePoint(kite, 0, { x: 0.2, y: 0.1 }, ALONE)).toEqual(kite);
		expect(movePoint(kite, 1, { x: 7, y: -7 }, ALONE)[1]).toEqual({ x: 1.023, y: -0.5, kind: "smooth" });
	});

	it("inserts points at a position, and on both sides with the lock", () => {
		const one = insertPoint(kite, 1, { x: 0.2, y: 0.7 }, ALONE);
		expect(one.map(({ y }) => y)).toEqual([0, 0.4, 0.7, 1, 0.4]);
		const two = insertPoint(kite, 3, { x: -0.2, y: 0.2 }, SAME);
		expect(two.map(({ x, y }) => [x, y])).toEqual([
			[0, 0],
			[0.2, 0.2],
			[0.3, 0.4],
			[0, 1],
			[-0.3, 0.4],
			[-0.2, 0.2],
		]);
		expect(two[insertedAt(4, 3, SAME)]).toMatchObject({ x: -0.2 });
		expect(one[insertedAt(4, 1, ALONE)]).toMatchObject({ x: 0.2 });
	});

	it("put one in the middle where a locked outline has no tip point", () => {
		const blunt = bothSides([kite[0], { x: 0.3, y: 0.9, kind: "corner" }]);
		expect(blunt).toHaveLength(3);
		const tipped = insertPoint(blunt, 1, { x: 0.1, y: 1 }, SAME);
		expect(tipped.map(({ x }) => x)).toEqual([0, 0.3, 0, -0.3]);
		expect(isSymmetric(tipped)).toBe(true);
	});

	it("take points out, but never the base nor the last few", () => {
		expect(removePoint(oak, 5, SAME)).toHaveLength(oak.length - 2);
		expect(removePoint(oak, 5, ALONE)).toHaveLength(oak.length - 1);
		expect(isSymmetric(removePoint(oak, 5, SAME))).toBe(true);
		expect(removePoint(oak, 0, ALONE)).toEqual(oak);
		expect(removePoint(kite, 1, SAME)).toEqual(kite);
		expect(removePoint(kite, 1, ALONE)).toHaveLength(FEWEST_POINTS);
	});

	it("never make more points than there may be", () => {
		let points: readonly OutlinePoint[] = oak;
		for (let times = 0; times < MAX_POINTS; times++) points = insertPoint(points, 1, { x: 0.1, y: 0.1 }, SAME);
		expect(points.length).toBe(MAX_POINTS);
	});

	it("turn a point through all kinds", () => {
		const kinds = [1, 2, 3, 4].reduce<OutlinePoint[][]>(
			(done) => [...done, turnKind(done.at(-1) ?? kite, 1, SAME)],
			[],
		);
		expect(kinds.map((each) => each[1].kind)).toEqual(["corner", "lobe", "pointed", "smooth"]);
		expect(kinds[0][mirrorOf(1, 4)].kind).toBe("corner");
	});

	it("make both sides alike from the right one", () => {
		const crooked = movePoint(oak, 3, { x: 0.2, y: 0.1 }, ALONE);
		expect(isSymmetric(crooked)).toBe(false);
		const symmetric = madeSymmetric(crooked);
		expect(isSymmetric(symmetric)).toBe(true);
		expect(symmetric.slice(0, 26)).toEqual(crooked.slice(0, 26));
	});
});

describe("an outline in a link", () => {
	it("decodes every outline to itself", () => {
		fc.assert(
			fc.property(fc.array(arbitraryPoint, { maxLength: MAX_POINTS }), (points) => {
				expect(unpackOutline(packOutline(points))).toEqual(points);
			}),
		);
	});

	it("takes four characters a point, and half of them where both sides are alike", () => {
		expect(packOutline(kite)).toHaveLength(1 + 4 * 3);
		expect(packOutline(movePoint(kite, 1, { x: 0.1, y: 0.1 }, ALONE))).toHaveLength(4 * 4);
		expect(packOutline(oak)).toMatch(/^~[\w-]+$/);
	});

	it("is nothing else", () => {
		for (const text of ["~AAA", "A", "AA!A", "~~AAAA"]) expect(unpackOutline(text)).toBeUndefined();
	});
});

describe("the curve", () => {
	it("goes through every point in turn", () => {
		const curve = curveOf(oak, 8);
		expect(curve).toHaveLength(8 * oak.length);
		oak.forEach(({ x, y }, index) => {
			expect(curve[8 * index].x).toBeCloseTo(x);
			expect(curve[8 * index].y).toBeCloseTo(y);
		});
	});

	it("runs on at smooth points and breaks at corners", () => {
		const turn = (index: number) => {
			const spans = spansOf(kite);
			const [before, after] = [spans[(index + 3) % 4], spans[index]];
			const one = Math.atan2(before.to.y - before.second.y, before.to.x - before.second.x);
			const other = Math.atan2(after.first.y - after.from.y, after.first.x - after.from.x);
			return Math.abs(one - other);
		};
		expect(turn(1)).toBeCloseTo(0);
		expect(turn(2)).toBeGreaterThan(0.5);
	});

	it("encloses a blade in every preset, but not where a point is taken past the other side", () => {
		for (const { name } of LEAF.presets.list) expect(enclosesBlade(leafFromPreset(name).outline)).toBe(true);
		expect(enclosesBlade(movePoint(kite, 1, { x: -0.5, y: 0.4 }, ALONE))).toBe(false);
		expect(enclosesBlade(movePoint(oak, 10, { x: -0.4, y: 0.4 }, ALONE))).toBe(false);
	});

	it("encloses a blade however upright or level its edges are", () => {
		const corners = (...places: [number, number][]) => places.map(([x, y]) => ({ x, y, kind: "corner" as const }));
		const right: [number, number][] = [
			[0.3, 0],
			[0.3, 1],
			[-0.3, 1],
			[-0.3, 0],
		];
		expect(enclosesBlade(corners([0, 0], ...right))).toBe(true);
		expect(enclosesBlade(corners([0, 0], [0.5, 0.5], [0, 1]))).toBe(true);
		// Down along the same line as up.
		expect(enclosesBlade(corners([0, 0], [0.3, 0], [0.3, 1], [0.3, 0.5], [-0.3, 0.5]))).toBe(false);
	});

	it("finds the span nearest to a position", () => {
		const spans = spansOf(oak);
		spans.forEach(({ from, to }, index) => {
			const halfway = { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
			expect(nearestSpan(oak, halfway).span).toBe(index);
		});
	});
});
