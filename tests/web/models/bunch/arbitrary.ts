/** Random small growths and specimens for property tests. */

import fc from "fast-check";
import type { Specimen } from "../../bunch";
import { evenly } from "../../evenly";
import { type GrownSketch, sampleSpecimen, unit, type Vector } from "./fixture";

const part = evenly(-1, 1);

/** Random directions, with upright and nearly upright ones more frequent than by chance. */
export const direction: fc.Arbitrary<Vector> = fc.oneof(
	fc
		.tuple(part, part, part)
		.filter((v) => Math.hypot(...v) > 1e-3)
		.map((v) => unit(v)),
	fc.constantFrom<Vector>([0, 1, 0], [0, -1, 0], [1, 0, 0], [0, 0, -1]),
	fc
		.tuple(part, fc.constantFrom(-1, 1), part, fc.integer({ min: 1, max: 9 }))
		.map(([x, y, z, power]) => unit([x * 10 ** -power, y, z * 10 ** -power])),
);

const pedicel = fc.record({
	direction,
	berryRadius: fc.oneof(fc.constant(0), evenly(1e-4, 0.05)),
});

export const sketch: fc.Arbitrary<GrownSketch> = fc.record({
	axes: fc.array(fc.array(pedicel, { maxLength: 4 }), { maxLength: 4 }),
	sides: fc.integer({ min: 3, max: 7 }),
	segments: fc.integer({ min: 6, max: 9 }),
	length: evenly(1e-3, 0.1),
});

const colour = fc.integer({ min: 0, max: 0xffffff }).map((bits) => bits.toString(16).padStart(6, "0"));

const share = fc.integer({ min: 0, max: 20 }).map((steps) => steps / 20);

export const specimen: fc.Arbitrary<Specimen> = fc
	.record({
		skin: colour,
		stem: colour,
		bloom: share,
		seed: fc.nat(),
		unripe: colour,
		glow: share,
		lenticels: share,
		uneven: share,
		age: fc.integer({ min: 0, max: 250 }).map((steps) => steps / 2),
		thinned: fc.uniqueArray(fc.nat(2 ** 30 - 1), { maxLength: 5 }),
		grammar: fc.option(fc.string({ unit: "grapheme" }), { nil: undefined }),
	})
	.map(({ seed, grammar, age, thinned, ...look }) => {
		const sample = sampleSpecimen({ seed, look, thinned, ...(grammar ? { grammar } : {}) });
		return { ...sample, parameters: { ...sample.parameters, age } };
	});
