import fc from "fast-check";

const STEPS = 1_000_000;

/**
 * Numbers evenly over a stretch, ends included. `fc.double` and `fc.float` are even over bit patterns: nearly all of their
 * numbers lie next to 0 or to an end, where places, angles and lengths hardly ever do.
 */
export const evenly = (min: number, max: number): fc.Arbitrary<number> =>
	fc.nat(STEPS).map((part) => min + ((max - min) * part) / STEPS);
