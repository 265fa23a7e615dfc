/** Appearance of a natural bunch in a GLB viewer. */
import { Color, type MeshPhysicalMaterial } from "three";
import { describe, expect, it } from "vitest";
import type { BunchPlant } from "../../../../../web/src/models/bunch/bunch_plant";
import { SKETCH } from "../fixture";
import { makeNatural, type NaturalChanges } from "../natural_fixture";
import { around, brightness, looking, read, shade } from "./natural_reading";

const fine = { ...SKETCH, segments: 24 };
const grown = makeNatural(fine);
const where = (traits: NaturalChanges["traits"]) => makeNatural(fine, { traits });

describe("the colours of a natural bunch", () => {
	it("darken a base that is as bright as the brightest vertex", async () => {
		const brightest = [0, 0, 0];
		for (const { geometry } of (await read(grown)).named("Berry ")) {
			const { color } = geometry.attributes;
			for (let i = 0; i < color.count; i++) {
				[color.getX(i), color.getY(i), color.getZ(i)].forEach((value, k) => {
					brightest[k] = Math.max(brightest[k], value);
				});
			}
		}
		// The base is a colour of eight bits of sRGB.
		for (const value of brightest) expect(value).toBeGreaterThan(0.98);
	});

	it("go from the unripe to the ripe colour as berries turn, by way of rose", async () => {
		const plain = looking({ bloom: 0, uneven: 0, unripe: "8ea552", skin: "43264f" });
		const { named } = await read(
			where((i) => ({ turned: i / 2 })),
			plain,
		);
		const [unripe, turning, ripe] = named("Berry ").map((mesh) => shade(mesh, around(mesh, 0.5, 0.03)[0]));
		const near = (colour: Color, hex: string) => {
			const [r, g, b] = new Color(`#${hex}`).toArray();
			expect(Math.hypot(colour.r - r, colour.g - g, colour.b - b)).toBeLessThan(0.03);
		};
		near(unripe, "8ea552");
		near(ripe, "43264f");
		expect(turning.r).toBeGreaterThan(turning.g);
		expect(brightness(turning)).toBeGreaterThan(brightness(ripe));
		expect(brightness(turning)).toBeLessThan(brightness(unripe));
	});

	it("turn from the tip, and in patches if uneven", async () => {
		const turning = where(() => ({ turned: 0.5 }));
		const reds = async (uneven: number) => {
			const [berry] = (await read(turning, looking({ bloom: 0, uneven }))).named("Berry ");
			const at = (v: number) => around(berry, v, 0.03).map((i) => shade(berry, i).g);
			return { seat: Math.max(...at(0.25)), tip: Math.max(...at(0.75)), ring: at(0.5) };
		};
		const even = await reds(0);
		expect(even.seat).toBeGreaterThan(1.5 * even.tip);
		expect(Math.max(...even.ring)).toBeLessThan(1.25 * Math.min(...even.ring));
		const patchy = await reds(1);
		expect(Math.max(...patchy.ring)).toBeGreaterThan(1.6 * Math.min(...patchy.ring));
	});

	it("lose the wax where berries touch", async () => {
		const [berry] = (await read(grown, looking({ bloom: 1, skin: "1d1c30" }))).named("Berry ");
		const { pressed = new Uint8Array() } = grown.surfaces ?? {};
		const mean = (touching: boolean) => {
			const those = around(berry, 0.5, 0.2).filter((i) => pressed[i] > 0 === touching);
			return those.reduce((sum, i) => sum + brightness(shade(berry, i)), 0) / those.length;
		};
		expect(mean(false)).toBeGreaterThan(1.5 * mean(true));
	});

	it("differ from berry to berry, and by sun, unless the look is even", async () => {
		const sunned = where((i) => ({ exposure: i / 2 }));
		const means = async (uneven: number) =>
			(await read(sunned, looking({ bloom: 0, uneven, skin: "c9a25a" }))).named("Berry ").map((mesh) => {
				const all = around(mesh, 0.5, 0.35).map((i) => brightness(shade(mesh, i)));
				return all.reduce((sum, each) => sum + each, 0) / all.length;
			});
		const spread = (values: number[]) => Math.max(...values) / Math.min(...values);
		expect(spread(await means(1))).toBeGreaterThan(1.06);
		expect(spread(await means(0))).toBeLessThan(1.03);
	});

	it("brown at the scar and on berries that dry", async () => {
		const { named } = await read(
			where((i) => ({ shrivel: i === 0 ? 1 : 0 })),
			looking({ bloom: 0, uneven: 0, skin: "c9a25a" }),
		);
		const [raisin, berry] = named("Berry ");
		const [middle] = around(berry, 0.5, 0.03);
		expect(brightness(shade(berry, around(berry, 1, 0)[0]))).toBeLessThan(0.75 * brightness(shade(berry, middle)));
		expect(brightness(shade(raisin, middle))).toBeLessThan(0.6 * brightness(shade(berry, middle)));
	});

	it("turn stems to wood as the berries turn and dry, the rachis first", async () => {
		const redness = async (state: { turned: number; shrivel?: number }, name: string) => {
			const [mesh] = (await read(where(() => state))).named(name);
			const all = around(mesh, 0.5, 1).map((i) => shade(mesh, i));
			return all.reduce((sum, { r, g }) => sum + r / g, 0) / all.length;
		};
		expect(await redness({ turned: 1 }, "Rachis")).toBeGreaterThan(1.2 * (await redness({ turned: 0 }, "Rachis")));
		expect(await redness({ turned: 1 }, "Rachis")).toBeGreaterThan(await redness({ turned: 1 }, "Axis 01"));
		expect(await redness({ turned: 1, shrivel: 1 }, "Axis 01")).toBeGreaterThan(
			await redness({ turned: 1 }, "Axis 01"),
		);
	});
});

describe("the materials of a natural bunch, as three.js reads them", () => {
	it("are of a bloomed, dark grape: sheen, a dull mirror, no light through it", async () => {
		const { skin } = await read(grown, looking({ skin: "33254a", bloom: 0.8 }));
		expect(skin.ior).toBe(1.4);
		expect(skin.sheen * skin.sheenColor.b).toBeGreaterThan(0.1);
		expect(skin.specularIntensity).toBeCloseTo(0.36);
		expect([skin.transmission, skin.clearcoat]).toEqual([0, 0.05]);
	});

	it("are of a pale grape: a little light passes, coloured by the flesh", async () => {
		const { skin } = await read(grown, looking({ skin: "c9cf86", glow: 1, bloom: 0 }));
		expect(skin.transmission).toBeGreaterThan(0.1);
		expect(skin.transmission).toBeLessThanOrEqual(0.3);
		expect(skin.thickness).toBeCloseTo(grown.berries.traits[0], 2);
		expect(skin.attenuationColor.b).toBeLessThan(skin.attenuationColor.g);
		expect(skin.side).toBe(0);
		const opaque = await read(grown, looking({ skin: "c9cf86", glow: 0 }));
		expect(opaque.skin.transmission).toBe(0);
	});

	it("are of a clean currant: a clear coat; of a rind: neither coat nor light", async () => {
		const of = (fruit: BunchPlant["form"]["fruit"]) => ({ ...grown, form: { ...grown.form, fruit } });
		const currant = await read(of("currant"), looking({ skin: "b8121c", bloom: 0 }));
		expect(currant.skin.clearcoat).toBeCloseTo(0.9);
		const rind = await read(of("lychee"), looking({ skin: "d3b778", bloom: 0, glow: 1 }));
		expect([rind.skin.clearcoat ?? 0, rind.skin.transmission ?? 0]).toEqual([0, 0]);
		expect(rind.skin.roughness).toBeGreaterThan(0.7);
	});

	it("show leaves from both sides, green until the berries dry", async () => {
		const leaf = async (shrivel: number) =>
			(await read(where(() => ({ shrivel })))).named("Leaf ")[0].material as MeshPhysicalMaterial;
		const [green, late] = [await leaf(0), await leaf(1)];
		expect(green.side).toBe(2);
		expect(green.color.g).toBeGreaterThan(green.color.r);
		expect(late.color.r).toBeGreaterThan(late.color.g);
	});
});
