import { describe, expect, it } from "vitest";
import { type BunchPlant, type FlowerPiece, TRAITS } from "../../../../../web/src/models/bunch/bunch_plant";
import { countOf, flowersOf } from "../../../../../web/src/models/bunch/parts/flowers";
import { TRANSFORM } from "../../../../../web/src/plant/part";
import { type PressedOptions, pressedBunch } from "../pressed_bunch";

type Place = [x: number, y: number, z: number];

const UNIT = 0.0005;
const RUN = { firstVertex: 0, vertexCount: 0, firstIndex: 0, indexCount: 0 };
const NOTHING = {
	positions: new Float32Array(0),
	normals: new Float32Array(0),
	uvs: new Float32Array(0),
	indices: new Uint32Array(0),
};
const OF_GRAPES: FlowerPiece[] = ["stamens", "cap", "pistil"];

interface Blooming extends PressedOptions {
	pieces?: FlowerPiece[];
}

function blooming({ pieces = OF_GRAPES, ...options }: Blooming): BunchPlant {
	const flower = { ...NOTHING, unit: UNIT, pieces: pieces.map((piece) => ({ piece, ...RUN })) };
	return { ...pressedBunch(options), flower };
}

/** How many of each kind of piece there are. */
function counted(options: Blooming) {
	const placed = flowersOf(blooming(options));
	return Object.fromEntries((options.pieces ?? OF_GRAPES).map((piece) => [piece, countOf(placed, piece)]));
}

/** Places of a kind of piece. */
function places(grown: BunchPlant, wanted: FlowerPiece): number[][] {
	return flowersOf(grown)
		.filter(({ piece }) => piece === wanted)
		.flatMap(({ transforms }) =>
			Array.from({ length: transforms.length / TRANSFORM }, (_, i) =>
				transforms.slice(TRANSFORM * i, TRANSFORM * i + 8),
			),
		);
}

describe("flowersOf", () => {
	it("gives an inflorescence of hundreds, each bud in its cap", () => {
		for (const count of [40, 100, 150]) {
			const { cap, pistil, stamens } = counted({ count, opened: 0, set: 0 });
			expect(cap).toBe(count + pistil);
			expect(cap).toBeGreaterThanOrEqual(200);
			expect(cap).toBeLessThanOrEqual(500);
			expect(stamens).toBe(0);
		}
		const many = Array.from({ length: 500 }, (_, id) => ({ id, why: "not set" as const, place: [0, 0, 0] as Place }));
		const enough = { ...blooming({ count: 100, opened: 0, set: 0 }), thinned: many };
		expect(countOf(flowersOf(enough), "pistil")).toBe(0);
	});

	it("keeps them as others fall: fallen flowers that set no berry still count", () => {
		const grown = blooming({ count: 100, opened: 1, set: 0 });
		const gone = Array.from({ length: 100 }, (_, id) => ({ id, why: "not set" as const, place: [0, 0, 0] as Place }));
		const beside = (thinned: BunchPlant["thinned"]) => countOf(flowersOf({ ...grown, thinned }), "pistil");
		// Of 200 flowers half are left, and half of those beside them.
		expect(beside(gone)).toBeLessThan(0.62 * beside([]));
		expect(beside(gone)).toBeGreaterThan(0.5 * 280 - 40);
	});

	it("sheds caps as flowers open, but for a few, and stamens as berries set", () => {
		const open = counted({ count: 150, opened: 1, set: 0 });
		expect(open.stamens).toBe(150 + open.pistil);
		expect(open.cap).toBeGreaterThan(0.08 * open.stamens);
		expect(open.cap).toBeLessThan(0.3 * open.stamens);
		expect(counted({ count: 150, opened: 1, set: 1 })).toEqual({ stamens: 0, cap: 0, pistil: 0 });
	});

	it("lifts a cap off its ovary before it falls", () => {
		const far = (opened: number) => {
			const grown = blooming({ count: 1, fruit: "duku", opened, set: 0 });
			const [[x, y, z]] = places(grown, "cap");
			const [cx, cy, cz] = grown.berries.spheres;
			return Math.hypot(x - cx, y - cy, z - cz) / grown.berries.spheres[3];
		};
		expect(far(0)).toBe(0);
		expect(far(0.6)).toBeGreaterThan(1.5);
	});

	it("unfolds stamens as a flower opens, and withers them as it sets", () => {
		const grown = blooming({ count: 1, fruit: "duku", opened: 0.5, set: 0.5 });
		const [[x, y, z, , , , , scale]] = places(grown, "stamens");
		expect([x, y, z]).toEqual([...grown.berries.spheres.subarray(0, 3)]);
		expect(scale).toBeCloseTo(0.25 * grown.berries.spheres[3], 9);
	});

	it("sets flowers beside a berry's own within a few radii of its seat, none in its place", () => {
		const grown = blooming({ count: 40, opened: 0, set: 0 });
		const { spheres, directions, traits } = grown.berries;
		const seats = Array.from({ length: 40 }, (_, i) =>
			[0, 1, 2].map((k) => spheres[4 * i + k] - 0.5 * traits[TRAITS.length * i + 1] * directions[3 * i + k]),
		);
		const away = places(grown, "pistil").map(([x, y, z]) =>
			Math.min(...seats.map(([sx, sy, sz]) => Math.hypot(x - sx, y - sy, z - sz))),
		);
		expect(Math.min(...away)).toBeGreaterThan(3 * UNIT);
		expect(Math.max(...away)).toBeLessThan(9 * UNIT);
	});

	it("has brambles flower alone and keep their calyx at the seat, fruit or not", () => {
		const pieces: FlowerPiece[] = ["stamens", "petals", "calyx"];
		expect(counted({ count: 9, fruit: "bramble", pieces, opened: 1, set: 0 })).toEqual({
			stamens: 9,
			petals: 9,
			calyx: 9,
		});
		expect(counted({ count: 9, fruit: "bramble", pieces, opened: 1, set: 1 })).toEqual({
			stamens: 0,
			petals: 0,
			calyx: 9,
		});
		const ripe = blooming({ count: 1, fruit: "bramble", pieces, opened: 1, set: 1, elongation: 1.5 });
		const [[x, y, z, , , , , scale]] = places(ripe, "calyx");
		const { spheres, directions, traits } = ripe.berries;
		for (const [k, at] of [x, y, z].entries()) expect(at).toBeCloseTo(spheres[k] - 0.5 * traits[1] * directions[k], 9);
		expect(scale).toBe(UNIT);
	});
});
