import { Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { CAST_RECORD, CASTERS, Casters, type Lamp } from "../../../../../web/src/models/bunch/render/casters";
import { receiversOf } from "../../../../../web/src/models/bunch/render/receivers";
import { lampHidden } from "../../../../../web/src/render/occlusion";
import { ripeTraits, sampleBunch } from "../sample_bunch";

const key: Lamp = { direction: [-0.566, 0.602, 0.564], spread: 0.17 };
const rim: Lamp = { direction: [0.8, 0, -0.6], spread: 0.2 };

const bunch = sampleBunch(90);
const receivers = receiversOf(bunch);
const records = new Float32Array(receivers.count * CAST_RECORD * 4);
new Casters().cast(receivers, key, rim, records);

/** Returns the spheres between receiver `i` and the light, by brute force. */
function inTheWay(i: number, lamp: Lamp): { j: number; along: number; lateral: number; radius: number }[] {
	const { spheres } = receivers.index;
	const at = 4 * i;
	const found = [];
	for (let j = 0; j < bunch.berries.count; j++) {
		if (j === i) continue;
		const d = [0, 1, 2].map((k) => spheres[4 * j + k] - receivers.bodies[at + k]);
		const along = d[0] * lamp.direction[0] + d[1] * lamp.direction[1] + d[2] * lamp.direction[2];
		const lateral = Math.sqrt(Math.max(0, d[0] ** 2 + d[1] ** 2 + d[2] ** 2 - along ** 2));
		found.push({ j, along, lateral, radius: spheres[4 * j + 3] });
	}
	return found;
}

describe("Casters", () => {
	it("lists the nearest spheres between each berry and the key light", () => {
		for (let i = 0; i < bunch.berries.count; i++) {
			const extent = receivers.bodies[4 * i + 3];
			const expected = inTheWay(i, key)
				.filter(({ along, lateral, radius }) => along > -radius && lateral < radius + extent)
				.sort((a, b) => a.along - b.along)
				.slice(0, 3);
			const listed: number[] = [];
			for (let k = 1; k <= CASTERS; k++) {
				const at = 4 * (CAST_RECORD * i + k);
				if (records[at + 3] === 0) break;
				const centre = [0, 1, 2].map((c) => records[at + c]);
				listed.push(nearestTo(centre));
			}
			for (const { j } of expected.slice(0, Math.max(0, CASTERS - 6))) expect(listed).toContain(j);
			expect(listed).not.toContain(i);
		}
	});

	it.each([
		["key", key, 0],
		["rim", rim, 1],
	] as const)("shares out the %s light as looking at every sphere would", (_, lamp, channel) => {
		for (let i = 0; i < receivers.count; i++) {
			let share = 1;
			for (const { radius, lateral, along, j } of inTheWay(i, lamp)) {
				if (j !== i) share *= 1 - lampHidden(radius, lateral, along, lamp.spread);
			}
			expect(Math.abs(records[4 * CAST_RECORD * i + channel] - share)).toBeLessThan(0.03);
		}
	});

	it("hides as much as geometry predicts: all, half, a small share, none", () => {
		const along = (by: number, lateral = 0): Sphere => [
			by * key.direction[0] + lateral * across[0],
			by * key.direction[1] + lateral * across[1],
			by * key.direction[2] + lateral * across[2],
			1,
		];
		const share = (...others: Sphere[]) => castOn([0, 0, 0, 1], ...others)[0];
		expect(share(along(3))).toBeCloseTo(0, 6);
		// Its edge on the ray to the lamp's middle: half of the lamp shows.
		expect(share(along(4, 1))).toBeCloseTo(0.5, 5);
		// Far away it is a disc before a larger one: nearly the ratio of their areas.
		expect(Math.abs(share(along(12)) - (1 - (1 / (12 * key.spread)) ** 2))).toBeLessThan(0.05);
		expect(share(along(-3))).toBe(1);
		expect(share(along(4, 3))).toBe(1);
		expect(share(along(3), along(4, 1))).toBeCloseTo(0, 6);
	});

	it("finds spheres beside the column but within the penumbra, on every side", () => {
		const towards = new Vector3(...unit(key.direction));
		const place = (by: number, lateral: Vector3): Sphere => {
			const at = towards.clone().multiplyScalar(by).add(lateral);
			return [at.x, at.y, at.z, 1];
		};
		for (let turn = 0; turn < 16; turn++) {
			const lateral = new Vector3(...across).applyAxisAngle(towards, (turn * Math.PI) / 8);
			// Others, behind, spread the grid's cells.
			const rest = [-9, 9].map((by) => place(-9, lateral.clone().multiplyScalar(by)));
			const [share] = castOn([0, 0, 0, 1], place(20, lateral.clone().multiplyScalar(3.6)), ...rest);
			expect(share).toBeLessThan(0.9999);
			expect(share).toBeGreaterThan(0.9);
		}
	});

	it("lists spheres beside and a little behind, for the pixels on that side, and none wholly behind", () => {
		const at = (by: number): Sphere => [
			by * key.direction[0] + 1.5 * across[0],
			by * key.direction[1] + 1.5 * across[1],
			by * key.direction[2] + 1.5 * across[2],
			1,
		];
		const listed = (by: number) => castOn([0, 0, 0, 1], at(by))[4 + 3] > 0;
		expect([listed(0.5), listed(-0.5), listed(-1.5)]).toEqual([true, true, false]);
	});

	it("recomputes only after changes", () => {
		const casters = new Casters();
		const fresh = records.slice().fill(7);
		expect(casters.cast(receivers, key, rim, fresh)).toBe(true);
		expect(casters.cast(receivers, { ...key }, { ...rim }, fresh)).toBe(false);
		const turned: Lamp = { ...rim, direction: [0, 0.6, 0.8] };
		const before = fresh[0];
		fresh[0] = -1;
		expect(casters.cast(receivers, key, turned, fresh)).toBe(true);
		// The key light's share was not worked out again.
		expect(fresh[0]).toBe(-1);
		expect(casters.cast(receivers, { ...key, spread: 0.2 }, turned, fresh)).toBe(true);
		expect(fresh[0]).not.toBe(-1);
		expect(before).toBeGreaterThanOrEqual(0);
		expect(casters.cast({ ...receivers }, { ...key, spread: 0.2 }, turned, fresh)).toBe(true);
	});

	it("leaves the berries nearest the light in it", () => {
		const toward = (i: number) => [0, 1, 2].reduce((sum, k) => sum + receivers.bodies[4 * i + k] * key.direction[k], 0);
		const order = Array.from({ length: bunch.berries.count }, (_, i) => i).sort((a, b) => toward(b) - toward(a));
		expect(records[4 * CAST_RECORD * order[0]]).toBeGreaterThan(0.95);
	});
});

type Sphere = [x: number, y: number, z: number, r: number];

/** A direction across the key light's. */
const across = [0.602, 0.566, 0].map((value) => value / Math.hypot(0.602, 0.566));

/** The record of the first of some spheres, each a berry. */
function castOn(...list: Sphere[]): Float32Array {
	const berries = {
		count: list.length,
		spheres: Float32Array.from(list.flat()),
		directions: Float32Array.from(list.flatMap(() => [0, -1, 0])),
		parent: Int32Array.from(list, (_, i) => i),
		ids: Uint32Array.from(list, (_, i) => i),
		traits: ripeTraits(list.flat()),
	};
	const none = { ...bunch.internodes, count: 0, ends: new Float32Array(0), radii: new Float32Array(0) };
	const few = { ...bunch, berries, internodes: none };
	const on = receiversOf(few);
	const cast = new Float32Array(on.count * CAST_RECORD * 4);
	new Casters().cast(on, { ...key, direction: unit(key.direction) }, rim, cast);
	return cast;
}

function unit(v: Lamp["direction"]): Lamp["direction"] {
	const length = Math.hypot(...v);
	return [v[0] / length, v[1] / length, v[2] / length];
}

function nearestTo(centre: number[]): number {
	const { spheres } = receivers.index;
	let best = -1;
	let least = Infinity;
	for (let j = 0; j < bunch.berries.count; j++) {
		const away = Math.hypot(...centre.map((c, k) => c - spheres[4 * j + k]));
		if (away < least) [best, least] = [j, away];
	}
	return best;
}
