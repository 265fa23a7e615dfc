import { describe, expect, it } from "vitest";
import type { BerrySurfaces, BunchPlant, Fruit } from "../../../../../web/src/models/bunch/bunch_plant";
import { paintedBerries, scarShare } from "../../../../../web/src/models/bunch/parts/berry_colour";
import { FRUIT_SKINS } from "../../../../../web/src/models/bunch/parts/fruit_skin";
import { type BunchDress, bunchSkin } from "../../../../../web/src/models/bunch/parts/skin";
import type { Look } from "../../../bunch";
import { type PressedOptions, pressedBunch } from "../pressed_bunch";
import { LOOK } from "../sample_bunch";

/** One berry, round and free, and its colours. */
function one(look: Partial<Look>, options: PressedOptions = {}, parameters?: BunchDress["parameters"]) {
	const grown: BunchPlant = pressedBunch({ count: 1, ...options });
	const surfaces = grown.surfaces as BerrySurfaces;
	const { colours, sky } = paintedBerries(
		grown,
		surfaces,
		bunchSkin(grown, { look: { ...LOOK, uneven: 0, bloom: 0, ...look }, parameters }),
	);
	const vertices = Array.from({ length: surfaces.uvs.length / 2 }, (_, vertex) => vertex);
	const mean = (wanted: (vertex: number) => boolean) => {
		const those = vertices.filter(wanted);
		return [0, 1, 2].map((k) => those.reduce((sum, v) => sum + colours[3 * v + k], 0) / those.length);
	};
	const v = (vertex: number) => surfaces.uvs[2 * vertex + 1];
	return { mean, v, sky, surfaces, grown };
}

const light = ([red, green, blue]: number[]) => 0.2126 * red + 0.7152 * green + 0.0722 * blue;
const middle = (v: number) => Math.abs(v - 0.5) < 0.2;

describe("paintedBerries", () => {
	it("hide the skin behind wax by its depth: on the face, about a sixth of it in full bloom", () => {
		const look = { skin: "101010", unripe: "101010" };
		const shown = (bloom: number) => {
			const { mean, v } = one({ ...look, bloom });
			return light(mean((vertex) => middle(v(vertex))));
		};
		const wax = light(bunchSkin(pressedBunch({ count: 1 }), { look: { ...LOOK, ...look } }).wax);
		const share = (shown(1) - shown(0)) / (wax - shown(0));
		expect(share).toBeGreaterThan(0.12);
		expect(share).toBeLessThan(0.2);
		expect(shown(0.5)).toBeGreaterThan(shown(0) + 0.4 * (shown(1) - shown(0)));
		expect(shown(0.5)).toBeLessThan(shown(0) + 0.75 * (shown(1) - shown(0)));
	});

	it("are shaded by berries that press on them", () => {
		const grown = pressedBunch({ count: 1 });
		const surfaces = grown.surfaces as BerrySurfaces;
		const vertices = surfaces.pressed.length;
		surfaces.pressed.fill(0);
		surfaces.pressed[5] = 255;
		surfaces.sky = new Uint8Array(vertices).fill(200);
		const { sky } = paintedBerries(grown, surfaces, bunchSkin(grown, { look: LOOK }));
		expect(sky?.[5]).toBe(90);
		expect(sky?.filter((value) => value === 200)).toHaveLength(vertices - 1);
		expect(surfaces.sky[5]).toBe(200);
	});

	it("are warmer and lighter among clear berries, as light goes to and fro there; dark ones as they are", () => {
		const gained = (skin: string, glow: number) => {
			const grown = pressedBunch({ count: 1 });
			const surfaces = grown.surfaces as BerrySurfaces;
			surfaces.pressed.fill(0);
			const dress = bunchSkin(grown, { look: { ...LOOK, uneven: 0, bloom: 0, skin, unripe: skin, glow } });
			const at = (sky: number) => {
				const colours = paintedBerries(
					grown,
					{ ...surfaces, sky: new Uint8Array(surfaces.pressed.length).fill(sky) },
					dress,
				).colours;
				return [0, 1, 2].map((k) => colours.reduce((sum, value, i) => sum + (i % 3 === k ? value : 0), 0));
			};
			const [open, deep] = [at(255), at(50)];
			return deep.map((value, k) => value / open[k]);
		};
		const [red, green] = gained("b2b262", 1);
		expect(green).toBeGreaterThan(1.04);
		expect(red).toBeGreaterThan(green + 0.03);
		for (const factor of gained("b2b262", 0)) expect(factor).toBeCloseTo(1, 5);
		for (const factor of gained("241a38", 0.5)) expect(Math.abs(factor - 1)).toBeLessThan(0.06);
	});

	it("show flesh that browns as it dries", () => {
		const warmth = (glow: number) => {
			const { mean, v } = one({ skin: "b2b262", unripe: "b2b262", glow }, { shrivel: 0.3 });
			const [red, green] = mean((vertex) => middle(v(vertex)));
			return red / green;
		};
		expect(warmth(1)).toBeGreaterThan(warmth(0));
	});

	it("differ less where flesh of one colour is seen through their skins", () => {
		const apart = (glow: number, shrivel: number) => {
			const look = { skin: "b2b262", unripe: "94ab58", glow, uneven: 1 };
			const grown = pressedBunch({ count: 2, shrivel });
			const surfaces = grown.surfaces as BerrySurfaces;
			const { colours } = paintedBerries(grown, surfaces, bunchSkin(grown, { look: { ...LOOK, bloom: 0, ...look } }));
			const half = colours.length / 2;
			let sum = 0;
			for (let i = 0; i < half; i++) sum += Math.abs(colours[i] - colours[half + i]);
			return sum / half;
		};
		expect(apart(1, 0)).toBeLessThan(0.75 * apart(0, 0));
		expect(apart(1, 1)).toBeCloseTo(apart(0, 1), 6);
	});

	it("take most of the wax off a raisin", () => {
		const shown = (shrivel: number, bloom: number) => {
			const { mean, v } = one({ skin: "101010", bloom }, { shrivel });
			return light(mean((vertex) => middle(v(vertex))));
		};
		expect(shown(1, 1) - shown(1, 0)).toBeLessThan(0.4 * (shown(0, 1) - shown(0, 0)));
	});

	it("are dark in the grooves between drupelets, where the surface is nearer the centre", () => {
		const dented = (fruit: Fruit) => {
			const grown = pressedBunch({ count: 1, fruit });
			const surfaces = grown.surfaces as BerrySurfaces;
			const [x, y, z] = grown.berries.spheres;
			// The far half sinks by a quarter.
			const centre = [x, y, z];
			const sunk = (vertex: number) => surfaces.positions[3 * vertex] < x;
			const before = surfaces.positions.slice();
			for (let i = 0; i < before.length / 3; i++) {
				if (before[3 * i] >= x) continue;
				for (let k = 0; k < 3; k++) surfaces.positions[3 * i + k] = centre[k] + 0.75 * (before[3 * i + k] - centre[k]);
			}
			const skin = bunchSkin(grown, { look: { ...LOOK, bloom: 0, uneven: 0 } });
			const { colours } = paintedBerries(grown, surfaces, skin);
			const green = (inside: boolean) => {
				const those = Array.from({ length: before.length / 3 }, (_, i) => i).filter((i) => sunk(i) === inside);
				return those.reduce((sum, i) => sum + colours[3 * i + 1], 0) / those.length;
			};
			return green(true) / green(false);
		};
		expect(dented("bramble")).toBeLessThan(0.35);
		expect(dented("lychee")).toBeGreaterThan(1.5);
		expect(dented("grape")).toBeGreaterThan(0.85);
	});

	it("mark the scar where the fruit has it, and none on brambles", () => {
		for (const [fruit, { scar }] of Object.entries(FRUIT_SKINS)) {
			const { mean, v } = one({ skin: "d8d8d8", unripe: "d8d8d8" }, { fruit: fruit as Fruit });
			const tip = light(mean((vertex) => (v(vertex) > 0.999 || v(vertex) < 0.001 ? v(vertex) > 0.5 : false)));
			const ring = light(mean((vertex) => middle(v(vertex))));
			if (scar > 1) expect(tip).toBeGreaterThan(0.7 * ring);
			// Corky, not black.
			else expect(tip / ring).toSatisfy((share: number) => share > 0.3 && share < 0.6);
		}
	});

	it("turn ripe pale skins amber towards the sun, and no others", () => {
		const sun = { sun: 90, sun_height: 0, sunlight: 0.8 };
		/** Blue beside red at the side in the sun, over the same on the other. */
		const gilt = (skin: string, options: PressedOptions = {}, parameters = sun) => {
			const { mean, surfaces, grown } = one({ skin, unripe: skin }, { exposure: 1, ...options }, parameters);
			const side = (way: number) => {
				const [red, , blue] = mean((v) => way * (surfaces.positions[3 * v] - grown.berries.spheres[0]) > 0.004);
				return blue / red;
			};
			return side(1) / side(-1);
		};
		expect(gilt("c4bd66")).toBeLessThan(0.75);
		expect(gilt("c4bd66", {}, { ...sun, sun: 270 })).toBeGreaterThan(1.3);
		for (const even of [
			gilt("43264f"),
			gilt("9c3546"),
			gilt("c4bd66", { turned: 0 }),
			gilt("c4bd66", { exposure: 0 }),
			gilt("c4bd66", {}, { ...sun, sunlight: 0 }),
		])
			expect(even).toSatisfy((share: number) => share > 0.85 && share < 1.2);
	});
});

describe("scarShare", () => {
	it("is 0 on the skin, 1 at the tip, and in between on its edge", () => {
		expect([scarShare(0.9, 0.98), scarShare(0.97, 0.98), scarShare(0.98, 0.98), scarShare(1, 0.98)]).toEqual([
			0,
			expect.closeTo(0.5, 6),
			1,
			1,
		]);
		expect(scarShare(1, FRUIT_SKINS.bramble.scar)).toBe(0);
	});
});
