import { describe, expect, it } from "vitest";
import { contourOf } from "../../../../web/src/import/tracing/contour";
import { type PixelImage, TraceError } from "../../../../web/src/import/tracing/picture";
import type { OutlinePoint, Place } from "../../../../web/src/models/leaf/outline/points";
import { curveOf } from "../../../../web/src/models/leaf/outline/spline";
import { leafFromPreset } from "../../../../web/src/models/leaf/schema";
import { MAX_TRACED, traceLeaf } from "../../../../web/src/models/leaf/trace/trace";
import { asChange } from "../../../../web/src/models/leaf/ui/trace";
import { inRun } from "../../../long_run.mjs";

type Ink = readonly [red: number, green: number, blue: number, alpha?: number];
const PAPER: Ink = [236, 232, 224];
const GREEN: Ink = [70, 110, 50];

const traceOutline = (picture: PixelImage) => traceLeaf(picture).outline;

/** A picture that is green where `inside` is true, with slight noise. */
function drawn(
	side: number,
	inside: (x: number, y: number) => boolean,
	paper: Ink = PAPER,
	leaf: Ink = GREEN,
): PixelImage {
	const data = new Uint8ClampedArray(4 * side * side);
	for (let at = 0; at < side * side; at++) {
		const [red, green, blue, alpha = 255] = inside((at % side) + 0.5, Math.floor(at / side) + 0.5) ? leaf : paper;
		const noise = ((at * 7919) % 13) - 6;
		data.set([red + noise, green + noise, blue + noise, alpha], 4 * at);
	}
	return { width: side, height: side, data };
}

function holds(polygon: readonly Place[], x: number, y: number): boolean {
	let inside = false;
	polygon.forEach((a, index) => {
		const b = polygon[(index + 1) % polygon.length];
		if (a.y > y !== b.y > y && x < a.x + ((y - a.y) / (b.y - a.y)) * (b.x - a.x)) inside = !inside;
	});
	return inside;
}

/** A leaf of `scale` pixels with a stalk, rotated by `turn` about the picture's centre. */
function leafPicture(
	points: readonly OutlinePoint[],
	{ side = 320, scale = 200, turn = 0, stalk = 0.4, thick = 0.012 } = {},
	...inks: Ink[]
) {
	const polygon = curveOf(points);
	const [cosine, sine] = [Math.cos(turn), Math.sin(turn)];
	const at = (px: number, py: number): Place => {
		const [dx, dy] = [px - side / 2, side / 2 - py];
		return { x: (dx * cosine + dy * sine) / scale, y: (dy * cosine - dx * sine) / scale + 0.4 };
	};
	const inside = (px: number, py: number) => {
		const { x, y } = at(px, py);
		return holds(polygon, x, y) || (Math.abs(x) < thick && y <= 0.02 && y > -stalk);
	};
	return drawn(side, inside, ...inks);
}

/** Intersection over union of two outlines. */
function likeness(one: readonly OutlinePoint[], other: readonly OutlinePoint[]): number {
	const [a, b] = [curveOf(one), curveOf(other)];
	let [both, either] = [0, 0];
	for (let x = -1; x <= 1; x += 0.02) {
		for (let y = -0.5; y <= 1.2; y += 0.02) {
			const [inOne, inOther] = [holds(a, x, y), holds(b, x, y)];
			both += inOne && inOther ? 1 : 0;
			either += inOne || inOther ? 1 : 0;
		}
	}
	return both / either;
}

/** Presets whose pictures without a stalk have no petiole. */
const BARE_LEAVES = ["beech", "willow", "strawberry", "lily-of-the-valley", "grapevine", "ginkgo", "tulip-tree"];

describe("an outline traced from a picture", () => {
	it.each(
		inRun(["grapevine", "oak", "willow"], ["grapevine", "oak", "maple", "lime", "willow", "ginkgo", "bodhi", "birch"]),
	)("is that of the leaf: %s", (name) => {
		const { outline } = leafFromPreset(name);
		const traced = traceOutline(leafPicture(outline, { thick: name === "willow" ? 0.007 : 0.012 }));
		expect(traced.length).toBeLessThanOrEqual(MAX_TRACED);
		expect(traced[0]).toMatchObject({ x: 0, y: 0 });
		expect(likeness(traced, outline)).toBeGreaterThan(name === "willow" ? 0.85 : 0.9);
	});

	it("does not depend on the leaf's rotation, which the stalk shows", () => {
		const { outline } = leafFromPreset("bodhi");
		for (const turn of inRun([2.4], [0.7, 2.4, Math.PI])) {
			expect(likeness(traceOutline(leafPicture(outline, { turn })), outline)).toBeGreaterThan(0.89);
		}
	});

	it("places the base of a leaf without a stalk at its lower end", () => {
		const { outline } = leafFromPreset("beech");
		expect(likeness(traceOutline(leafPicture(outline, { stalk: 0 })), outline)).toBeGreaterThan(0.95);
	});

	/** A star of five lobes on a base that is `wide` at the top and half as wide at its flat lower end. */
	const STAR: readonly (readonly [number, number])[] = [
		[0.42, 0.05],
		[0.3, 0.38],
		[0.5, 0.62],
		[0.2, 0.7],
		[0, 1],
	];
	const starOn = (foot: number, wide: number) => {
		const half = [[wide / 4, -foot], [wide / 2, 0], ...STAR];
		const polygon = [...half, ...half.toReversed().map(([x, y]) => [-x, y])].map(([x, y]) => ({ x, y }));
		return drawn(360, (px, py) => holds(polygon, (px - 180) / 220, (270 - py) / 220));
	};

	it("treats a narrow lower end of a silhouette as the petiole, without lobes there", () => {
		const { outline, petiole } = traceLeaf(starOn(0.36, 0.2));
		expect(petiole?.length).toBeCloseTo(0.36, 1);
		// As wide as near its end: towards the blade it widens into it.
		expect(petiole?.width).toBeGreaterThan(0.1);
		expect(petiole?.width).toBeLessThan(0.13);
		const tips = outline.filter(({ kind }) => kind === "pointed" || kind === "lobe");
		expect(tips).toHaveLength(5);
		for (const { y } of outline) expect(y).toBeGreaterThan(-0.05);
		expect(Math.max(...tips.map(({ y }) => y))).toBeCloseTo(1, 1);
	});

	it("takes a thin stalk for the petiole too, and none for none", () => {
		const { outline } = leafFromPreset("lime");
		const { petiole } = traceLeaf(leafPicture(outline, { stalk: 0.4, thick: 0.012 }));
		expect(petiole?.length).toBeGreaterThan(0.28); // its upper end is between the ears
		expect(petiole?.length).toBeLessThan(0.45);
		expect(petiole?.width).toBeCloseTo(0.024, 2);
		for (const name of inRun(["willow", "ginkgo"], BARE_LEAVES))
			expect(traceLeaf(leafPicture(leafFromPreset(name).outline, { stalk: 0 })).petiole, name).toBeUndefined();
		// A base this wide is not a petiole.
		expect(traceLeaf(starOn(0.36, 0.6)).petiole).toBeUndefined();
	});

	it("sets the picture's teeth and petiole in the same change, with messages", () => {
		const specimen = leafFromPreset("grapevine");
		const traced = traceLeaf(starOn(0.36, 0.2));
		const { change, messages } = asChange(traced, specimen);
		expect(change.details).toEqual({ outline: traced.outline });
		expect(change.parameters).toEqual({
			teeth: 0,
			petiole: Math.round(100 * (traced.petiole?.length ?? 0)),
			petiole_width: Math.round(10 * 110 * (traced.petiole?.width ?? 0)) / 10,
		});
		expect(messages).toHaveLength(2);
		expect(messages[0]).toContain("Teeth");
		const smooth = { ...specimen, parameters: { ...specimen.parameters, teeth: 0 } };
		expect(asChange({ outline: traced.outline }, smooth)).toEqual({
			change: { parameters: { teeth: 0 }, details: { outline: traced.outline } },
			messages: [],
		});
	});

	it("takes pale leaves on dark ground, and leaves on clear ground", () => {
		const { outline } = leafFromPreset("lime");
		for (const inks of [
			[
				[20, 24, 30],
				[200, 180, 90],
			] as Ink[],
			[
				[0, 0, 0, 0],
				[40, 60, 30],
			] as Ink[],
		]) {
			expect(likeness(traceOutline(leafPicture(outline, {}, ...inks)), outline)).toBeGreaterThan(0.9);
		}
	});

	it("distinguishes tips of lobes from teeth and curves", () => {
		const kinds = (name: string) => traceOutline(leafPicture(leafFromPreset(name).outline)).map(({ kind }) => kind);
		expect(kinds("maple").filter((kind) => kind === "pointed").length).toBeGreaterThanOrEqual(3);
		expect(kinds("lime").filter((kind) => kind === "pointed").length).toBeLessThanOrEqual(1);
	});

	it("passes over specks and holes", () => {
		const { outline } = leafFromPreset("beech");
		const plain = leafPicture(outline);
		const marked = { ...plain, data: plain.data.slice() };
		for (const [x, y, ink] of [
			[20, 20, GREEN],
			[160, 150, PAPER],
		] as const) {
			for (let i = 0; i < 25; i++)
				marked.data.set(ink.slice(0, 3) as number[], 4 * ((y + Math.floor(i / 5)) * 320 + x + (i % 5)));
		}
		expect(traceOutline(marked)).toEqual(traceOutline(plain));
	});

	it.each([
		["an empty picture", drawn(60, () => false), "Could not find a leaf"],
		["a speck", drawn(200, (x, y) => x > 100 && x < 104 && y > 100 && y < 104), "Could not find a leaf"],
		["a leaf that runs out", drawn(100, (x, y) => Math.hypot(x - 50, y) < 48), "reaches the edge of the picture"],
	])("refuses %s in plain words", (_, picture, words) => {
		expect(() => traceOutline(picture)).toThrow(TraceError);
		expect(() => traceOutline(picture)).toThrow(words);
	});
});

describe("the edge of a mask", () => {
	it("goes round pixels clockwise, diagonal neighbours apart", () => {
		const inside = Uint8Array.from([1, 1, 0, 0, 1, 0, 0, 0, 0]);
		const corners = contourOf({ width: 3, height: 3, inside });
		expect(corners.map(({ x, y }) => `${x}${y}`).join(" ")).toBe("00 10 20 21 22 12 11 01");
	});
});
