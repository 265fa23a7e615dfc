import { describe, expect, it } from "vitest";
import { TRAITS } from "../../../../../web/src/models/bunch/bunch_plant";
import { metresPerPixel } from "../../../../../web/src/models/bunch/profile/handles";
import { inkSilhouette, type Pen, sameScene } from "../../../../../web/src/models/bunch/profile/silhouette_canvas";
import { viewFrame } from "../../../../../web/src/models/bunch/profile/view_frame";

const PIXEL = metresPerPixel(0.25);
const inPixels = (...values: number[]) => Float32Array.from(values, (value) => value * PIXEL);
const rest = new Array<number>(TRAITS.length - 2).fill(0);

/** Two berries that overlap, the first in front; one internode. */
const bunch = {
	berries: {
		count: 2,
		spheres: inPixels(10, -100, 40, 12, 0, -110, -60, 12),
		directions: Float32Array.of(0, -1, 0, 0, -1, 0),
		parent: new Int32Array(2),
		ids: Uint32Array.of(0, 1),
		traits: Float32Array.of(24 * PIXEL, 24 * PIXEL, ...rest, 24 * PIXEL, 24 * PIXEL, ...rest),
	},
	internodes: {
		count: 1,
		parent: Int32Array.of(-1),
		kind: new Uint32Array(1),
		axis: Int32Array.of(-1),
		state: new Uint8Array(1),
		ends: inPixels(0, 0, 0, 3, -29, 5),
		radii: new Float32Array(2),
	},
};
const scene = { bunch, view: "front", unit: 0.25, frame: viewFrame(240, 240, 150), ratio: 2, ink: "red" } as const;

/** A pen that records its calls with numbers rounded, and fills and strokes with their mode. */
function recorder() {
	const notes: string[] = [];
	const note =
		(name: string) =>
		(...numbers: number[]) =>
			notes.push([name, ...numbers.map((value) => Math.round(value) + 0)].join(" "));
	const pen = {
		lineWidth: 1,
		lineCap: "butt",
		strokeStyle: "",
		globalCompositeOperation: "source-over",
		setTransform: note("transform"),
		beginPath: () => {},
		moveTo: note("move"),
		lineTo: note("line"),
		ellipse: note("ellipse"),
		fill: () => notes.push(`fill ${pen.globalCompositeOperation}`),
		stroke: () => notes.push(`stroke ${pen.globalCompositeOperation} ${pen.strokeStyle}`),
	};
	return { pen: pen as unknown as Pen, notes };
}

describe("inkSilhouette", () => {
	it("draws stems, then berries from the farthest, each of which erases those behind it", () => {
		const { pen, notes } = recorder();
		inkSilhouette(pen, scene);
		expect(notes.slice(1)).toEqual([
			"move 0 0",
			"line 3 29",
			"stroke source-over red",
			"ellipse 0 110 12 12 2 0 6",
			"fill destination-out",
			"stroke source-over red",
			"ellipse 10 100 12 12 2 0 6",
			"fill destination-out",
			"stroke source-over red",
		]);
	});

	it("puts the profile's p1 where the view has it, on a screen of any density", () => {
		const { pen, notes } = recorder();
		inkSilhouette(pen, scene);
		// 240 CSS pixels of two each: p1 in the middle, 14 CSS pixels from the top; 212 of them are 150 of the profile.
		expect(notes[0]).toBe("transform 3 0 0 3 240 28");
		expect(pen.lineWidth * scene.frame.scale).toBeCloseTo(0.8, 12);
	});
});

describe("sameScene", () => {
	it("detects the change of every input", () => {
		expect(sameScene(scene, { ...scene, frame: { ...scene.frame } })).toBe(true);
		const others = [
			{ bunch: { ...bunch } },
			{ view: "side" },
			{ unit: 0.5 },
			{ frame: viewFrame(240, 240, 200) },
			{ frame: viewFrame(250, 240, 150) },
			{ ratio: 1 },
			{ ink: "blue" },
		] as const;
		for (const other of others) expect(sameScene(scene, { ...scene, ...other })).toBe(false);
	});
});
