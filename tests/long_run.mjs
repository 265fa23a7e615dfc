/**
 * The two test runs. `npm test` is the gate: it runs at every change, with fixed seeds. `npm run test:long` runs
 * everything, more of it, with random seeds; it sets `PANICLE_LONG=1`.
 */
export const isLongRun = process.env.PANICLE_LONG === "1";

/**
 * The size of a repeated test: `gate` repetitions in `npm test`, `long` in `npm run test:long`.
 *
 * @template T
 * @param {T} gate
 * @param {T} long
 * @returns {T}
 */
export const inRun = (gate, long) => (isLongRun ? long : gate);
