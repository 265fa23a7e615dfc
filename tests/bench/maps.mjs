/** Generalized maps: time to build one, to validate it, and to place it again. */
import { KERNELS, nativeKernel } from "./core.mjs";
import { microseconds, printTable } from "./statistics.mjs";

const RUNS = 9;
const KINDS = [
	["map_build", "built", 50],
	["map_check", "checked", 20],
	["map_embed", "embedded", undefined],
	["map_place", "placed", undefined],
];
const milliseconds = (micro) => (micro / 1000).toFixed(2);

export function benchMaps({ core }) {
	for (const darts of [100_000, 1_000_000]) {
		const rows = [["", "darts", "aim ms", "wasm ms", "native ms", "ratio"]];
		for (const [kernel, title, aim] of KINDS) {
			const work = core.panicle_bench(KERNELS[kernel], darts, 1);
			const wasm = microseconds(1, RUNS, () => core.panicle_bench(KERNELS[kernel], darts, 1));
			const native = nativeKernel(kernel, darts, 1, RUNS).microseconds;
			const aimed = aim && darts === 1_000_000 ? aim : "–";
			rows.push([title, work, aimed, milliseconds(wasm), milliseconds(native), (wasm / native).toFixed(2)]);
		}
		printTable(`A generalized map of ${darts} darts: a vein with six lobes a step, glued`, rows);
	}
}
