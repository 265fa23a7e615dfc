import { expect, it } from "vitest";
import { separateColours } from "../../../../web/src/models/stand/ui/separate_colours";
import { fromLch, type Lch, linear, toLch } from "../../../../web/src/plant/colour";

const RANGE = [0.63, 0.97] as const;
/** The separated colours, as displayed. */
const shown = (...hex: string[]) =>
	separateColours(
		hex.map((each) => toLch(linear(each))),
		RANGE,
	).map((each) => toLch(fromLch(each)));
const degrees = ({ hue }: Lch) => ((hue * 180) / Math.PI + 360) % 360;
const apart = (one: Lch, other: Lch) => {
	const [a, b] = [one, other].map(({ chroma, hue }) => [chroma * Math.cos(hue), chroma * Math.sin(hue)]);
	return Math.hypot(one.lightness - other.lightness, a[0] - b[0], a[1] - b[1]);
};
const allApart = (colours: readonly Lch[]) => {
	for (const [i, one] of colours.entries())
		for (const other of colours.slice(0, i)) expect(apart(one, other)).toBeGreaterThan(0.069);
};

it("does not change distinct colours unless they are too dark or too light", () => {
	const [red, green, black, white] = shown("f07070", "70c050", "000000", "ffffff");
	expect(apart(red, toLch(linear("f07070")))).toBeLessThan(1e-3);
	expect(apart(green, toLch(linear("70c050")))).toBeLessThan(1e-3);
	expect(black.lightness).toBeCloseTo(0.63, 3);
	expect(white.lightness).toBeCloseTo(0.97, 3);
});

it("leaves two yellows yellow", () => {
	const yellows = shown("f5d020", "f2d22a");
	allApart(yellows);
	for (const each of yellows) {
		expect(Math.abs(degrees(each) - 97)).toBeLessThan(12);
		expect(each.chroma).toBeGreaterThan(0.12);
	}
});

it("makes the second of two whites a pale grey instead of salmon", () => {
	const whites = shown("fbfaf5", "fafaf6", "ffffff");
	allApart(whites);
	for (const each of whites) {
		expect(each.chroma).toBeLessThan(0.03);
		expect(each.lightness).toBeGreaterThan(0.75);
	}
});

it("keeps three greens green, each lighter or darker than the others", () => {
	const greens = shown("5e9a3c", "5c983e", "60993a");
	allApart(greens);
	for (const each of greens) expect(Math.abs(degrees(each) - 135)).toBeLessThan(15);
});

it("turns hues only where lightness has no room left, and stays within it", () => {
	const many = shown(...Array<string>(12).fill("888888"));
	allApart(many);
	for (const { lightness } of many) {
		expect(lightness).toBeGreaterThan(RANGE[0] - 0.01);
		expect(lightness).toBeLessThan(RANGE[1] + 0.01);
	}
	expect(many.slice(0, 4).every(({ chroma }) => chroma < 0.01)).toBe(true);
	expect(many.slice(8).some(({ chroma }) => chroma > 0.05)).toBe(true);
});

it("sees colours as screens do, which have no red that is lighter and as red", () => {
	allApart(shown("ff0000", "ff0000"));
	allApart(shown("ff00ff", "ff00ff", "ffff00", "ffff00", "ffff00"));
});
