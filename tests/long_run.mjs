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

/**
 * The names that a repeated test runs: those in `gate` in `npm test`, all of them in `npm run test:long`.
 *
 * @param {readonly string[]} names
 * @param {readonly string[]} gate
 */
export const namesInRun = (names, gate) => names.filter((name) => isLongRun || gate.includes(name));
