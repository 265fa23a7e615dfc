import { expect, it } from "vitest";
import { groundColour, kindColours } from "../../../../web/src/models/stand/ui/map_colours";
import { linear, toLch } from "../../../../web/src/plant/colour";
import { grownStand, planned } from "./stands";

const light = (hex: string) => {
	const [red, green, blue] = linear(hex);
	return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
};
const flowers = ["poppy", "lily", "bluebell", "buttercup", "globeflower", "grass"];
const plan = (names: readonly string[]) =>
	`ground 2 x 2\nplants ${6 * names.length}, stratified\n${names.map((name) => `flower/${name}, crown 0.1 x 0.1`).join("\n")}`;

it("shows each kind in the colour of its flowers, distinct from other kinds and from the ground", async () => {
	const stand = await grownStand(planned(plan(flowers)), { meshes: true });
	const colours = kindColours(stand);
	const [poppy, lily, bluebell, buttercup, globeflower, grass] = colours.map((each) => toLch(linear(each)));
	const degrees = ({ hue }: typeof poppy) => ((hue * 180) / Math.PI + 360) % 360;
	expect(degrees(poppy)).toBeLessThan(45);
	expect(lily.chroma).toBeLessThan(0.05);
	expect(lily.lightness).toBeGreaterThan(0.8);
	expect(degrees(bluebell)).toBeGreaterThan(260);
	expect(degrees(bluebell)).toBeLessThan(300);
	for (const yellow of [buttercup, globeflower]) expect(Math.abs(degrees(yellow) - 95)).toBeLessThan(25);
	expect(Math.abs(degrees(grass) - 125)).toBeLessThan(20);
	expect(new Set(colours).size).toBe(flowers.length);
	expect(Math.abs(buttercup.lightness - globeflower.lightness)).toBeGreaterThan(0.04);
	for (const soil of ["6b5843", "ffffff", "000000"])
		for (const each of colours) expect((light(each) + 0.05) / (light(groundColour(soil)) + 0.05)).toBeGreaterThan(2.9);
});

it("has one colour per name, distinct colours for similar kinds, and one colour for plants that have not grown", async () => {
	const stand = await grownStand(planned(plan(["daisy", "daisy"])), { meshes: true });
	expect(new Set(kindColours(stand)).size).toBe(1);
	const [one, other] = stand.kinds;
	const [first, second] = kindColours({ ...stand, kinds: [one, { ...other, name: "flower/other" }] });
	const [a, b] = [first, second].map((each) => toLch(linear(each)));
	const across = a.chroma * Math.cos(a.hue) - b.chroma * Math.cos(b.hue);
	const up = a.chroma * Math.sin(a.hue) - b.chroma * Math.sin(b.hue);
	expect(Math.hypot(a.lightness - b.lightness, across, up)).toBeGreaterThan(0.06);
	const none = kindColours({ ...stand, members: [] });
	expect(none[0]).toMatch(/^#[0-9a-f]{6}$/);
});
