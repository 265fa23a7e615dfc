import { describe, expect, it } from "vitest";
import {
	FAR,
	NEIGHBOURS,
	packReceivers,
	RECORD,
	receiverTexels,
} from "../../../../../web/src/models/bunch/figure/receivers";
import type { Grown } from "../../../../../web/src/models/bunch/grown";
import { berryTint } from "../../../../../web/src/models/bunch/parts/berry_tint";
import { skinOf } from "../../../../../web/src/models/bunch/parts/skin";
import { pressedBunch } from "../pressed_bunch";
import { LOOK, RIPE, ripeTraits, sampleBunch } from "../sample_bunch";

const skin = skinOf(LOOK);
const pack = (grown: Grown, records = new Float32Array(4 * receiverTexels(grown))) =>
	packReceivers(grown, (berry) => berryTint(skin, berry, RIPE), records);

/** Floats before the list of neighbours. */
const NEAR = 4 * (FAR + 1);

/** A bunch of bare spheres. */
function spheres(...list: [x: number, y: number, z: number, r: number][]): Grown {
	const bunch = sampleBunch(1);
	return {
		...bunch,
		berries: {
			count: list.length,
			spheres: Float32Array.from(list.flat()),
			directions: Float32Array.from(list.flatMap(() => [0, -1, 0])),
			parent: Int32Array.from(list, (_, i) => i),
			ids: Uint32Array.from(list, (_, i) => i),
			traits: ripeTraits(list.flat()),
		},
		internodes: { ...bunch.internodes, count: 0, ends: new Float32Array(0), radii: new Float32Array(0) },
	};
}

describe("packReceivers", () => {
	it("writes each berry's sphere and direction where the shader looks for them", () => {
		const bunch = sampleBunch(40);
		const { records, count } = pack(bunch);
		expect(count).toBe(bunch.berries.count + bunch.internodes.count);
		for (let i = 0; i < bunch.berries.count; i++) {
			const at = 4 * RECORD * i;
			expect([...records.subarray(at, at + 4)]).toEqual([...bunch.berries.spheres.subarray(4 * i, 4 * i + 4)]);
			expect([...records.subarray(at + 4, at + 7)]).toEqual([...bunch.berries.directions.subarray(3 * i, 3 * i + 3)]);
		}
	});

	it("writes half width, half length and what age has done to a berry", () => {
		const bunch = pressedBunch({ count: 8, elongation: 1.5, turned: 0.25, shrivel: 0.5, seeds: 2 });
		const { records } = pack(bunch);
		const [width, length] = bunch.berries.traits;
		expect(records[3]).toBeCloseTo(length / 2, 7);
		expect(records[15]).toBe(0.25);
		expect([...records.subarray(16, 20)]).toEqual([
			expect.closeTo(width / 2, 7),
			expect.closeTo(length / 2, 7),
			0.5,
			2,
		]);
	});

	it("lets a long berry hide light along its whole length, but not its own", () => {
		const long = pressedBunch({ count: 1, elongation: 2.5 });
		const { owner, index, records } = pack(long);
		expect([...owner]).toEqual([0, 0, 0]);
		expect(index.count).toBe(3);
		expect(records[NEAR + 3]).toBe(0);
		expect(records[4 * FAR]).toBe(0);
	});

	it("writes each internode's middle, half axis, radius and state", () => {
		const bunch = sampleBunch(40);
		const { records } = pack(bunch);
		const { ends, state, radii } = bunch.internodes;
		for (let i = 0; i < bunch.internodes.count; i++) {
			const at = 4 * RECORD * (bunch.berries.count + i);
			for (let k = 0; k < 3; k++) {
				expect(records[at + k] - records[at + 4 + k]).toBeCloseTo(ends[6 * i + k], 6);
				expect(records[at + k] + records[at + 4 + k]).toBeCloseTo(ends[6 * i + 3 + k], 6);
			}
			expect(records[at + 7]).toBeCloseTo(radii[2 * i], 7);
			expect(records[at + 8]).toBe(state[i]);
		}
	});

	it("lists the touching spheres first, relative to the centre, and ends the list with a zero", () => {
		const { records } = pack(spheres([0, 0, 0, 1], [2, 0, 0, 1], [0, -2, 0, 1], [9, 0, 0, 1]));
		const list = Array.from({ length: 4 }, (_, k) => [...records.subarray(NEAR + 4 * k, NEAR + 4 * k + 4)]);
		expect(list.slice(0, 2)).toEqual(
			expect.arrayContaining([
				[2, 0, 0, 1],
				[0, -2, 0, 1],
			]),
		);
		expect(list[2]).toEqual([9, 0, 0, 1]);
		expect(list[3][3]).toBe(0);
	});

	it("sums up the spheres that are not on the list as a constant and a direction", () => {
		const ring = Array.from({ length: NEIGHBOURS }, (_, k): [number, number, number, number] => [
			2 * Math.cos(k),
			0.001 * k,
			2 * Math.sin(k),
			0.5,
		]);
		const { records } = pack(spheres([0, 0, 0, 1], ...ring, [0, 4, 0, 1]));
		// sin²α = 1/16: a quarter of it all round, half of it along +Y.
		expect(records[4 * FAR]).toBeCloseTo(1 / 64, 6);
		expect([...records.subarray(4 * FAR + 1, 4 * FAR + 4)]).toEqual([0, expect.closeTo(1 / 32, 6), 0]);
	});

	it("leaves nothing of a larger bunch behind when its memory is used again", () => {
		const large = sampleBunch(90);
		const memory = new Float32Array(4 * receiverTexels(large));
		pack(large, memory);
		const small = sampleBunch(12, 7);
		const used = 4 * receiverTexels(small);
		const again = pack(small, memory).records.slice(0, used);
		expect(usedParts(again)).toEqual(usedParts(pack(small).records));
	});
});

/** The records without what stands after the zero that ends a list. */
function usedParts(records: Float32Array): number[] {
	const parts: number[] = [];
	for (let at = 0; at < records.length; at += 4 * RECORD) {
		parts.push(...records.subarray(at, at + NEAR));
		for (let k = FAR + 1; k < RECORD && records[at + 4 * k + 3] > 0; k++) {
			parts.push(...records.subarray(at + 4 * k, at + 4 * k + 4));
		}
	}
	// Minus zero is zero.
	return parts.map((value) => value + 0);
}
