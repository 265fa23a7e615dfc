/**
 * Leaf, tree and root: time of the particle system for growing numbers of particles, compared with a brute-force
 * search for neighbours and with a tree by space colonisation with as many points; and whole plants with their meshes.
 */
import { grower, KERNELS, nativeGrow, nativeKernel } from "./core.mjs";
import { microseconds, printTable } from "./statistics.mjs";

const SIZES = [1_000, 10_000, 100_000];
/** Most particles of the brute-force search, which takes too long for more. */
const MAX_BRUTE = 10_000;
const PLANTS = [
	["leaf", 2_000, 50],
	["tree", 20_000, 300],
	["root", 2_000, undefined],
];
const RUNS = 5;

const milliseconds = (micro) => (micro / 1000).toFixed(micro < 10_000 ? 2 : 0);

export async function benchParticles({ core, source }) {
	benchCrowds(core);
	await benchPlants(core, source);
}

function benchCrowds(core) {
	for (const place of ["flat", "space"]) {
		const rows = [["particles", "merges", "wasm ms", "native ms", "ratio", "brute ms", "colonisation ms", "its nodes"]];
		const times = [];
		for (const size of SIZES) {
			const runs = size > 10_000 ? 1 : RUNS;
			const timed = (kernel) => microseconds(1, runs, () => core.panicle_bench(KERNELS[`${kernel}_${place}`], size, 1));
			const work = (kernel) => core.panicle_bench(KERNELS[`${kernel}_${place}`], size, 1);
			const wasm = timed("crowd");
			const native = nativeKernel(`crowd_${place}`, size, 1, runs).microseconds;
			times.push(wasm);
			rows.push([
				size,
				work("crowd"),
				milliseconds(wasm),
				milliseconds(native),
				(wasm / native).toFixed(2),
				size <= MAX_BRUTE ? milliseconds(timed("brute")) : "–",
				milliseconds(timed("colonise")),
				work("colonise"),
			]);
		}
		const exponent = (from, to) => Math.log(times[to] / times[from]) / Math.log(SIZES[to] / SIZES[from]);
		printTable(`Particles ${place === "flat" ? "in a disc" : "in a ball"}, scattered and run home`, rows);
		console.log(
			`exponent 1 k … 10 k: ${exponent(0, 1).toFixed(2)}, 10 k … 100 k: ${exponent(1, 2).toFixed(2)} (aim 1.15 at the most)\n`,
		);
	}
}

async function benchPlants(core, source) {
	const { writeContainer } = await source("web/src/core/container.ts");
	const { fromPreset } = await source("web/src/specimen/from_preset.ts");
	const rows = [["plant", "particles", "aim ms", "wasm ms", "native ms", "ratio", "a step of a drag, wasm ms"]];
	for (const [name, particles, aim] of PLANTS) {
		const { model } = await source(`web/src/models/particles/${name}/index.ts`);
		const specimen = fromPreset(model);
		specimen.parameters.particles = particles;
		const request = (options) => writeContainer(model.encode(specimen, options));
		const whole = request({ measures: false });
		const wasm = microseconds(1, RUNS, grower(core, whole));
		const native = nativeGrow(whole, 1, RUNS);
		const preview = microseconds(1, RUNS, grower(core, request({ preview: true })));
		const ratio = (wasm / native).toFixed(2);
		rows.push([name, particles, aim ?? "–", milliseconds(wasm), milliseconds(native), ratio, milliseconds(preview)]);
	}
	printTable("Standard presets, with meshes and sky", rows);
}
