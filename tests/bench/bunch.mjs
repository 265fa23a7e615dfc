/**
 * `npm run bench -- core`: bunches as wasm and natively: the natural procedure, the paper's, Table 2 of the paper, the kernels of
 * the core, and the cost by the size of the plan.
 */

import { grower, KERNELS, nativeGrow, nativeKernel } from "./core.mjs";
import { benchNatural } from "./natural.mjs";
import { peerModules } from "./peer.mjs";
import { geometricMean, median, microseconds, printTable } from "./statistics.mjs";

/** Huang et al. 2013, Table 2: internodes, berries, milliseconds on a Core i5-3470. */
const TABLE_2 = [
	[179, 41, 610],
	[177, 53, 697],
	[177, 75, 816],
	[178, 82, 831],
	[172, 102, 919],
	[183, 110, 1009],
	[197, 118, 1108],
];
const RADII = [40, 35, 30, 25, 20, 15, 10];
const RUNS = 15;
const DERIVE_STEPS = 16;

const digits = (number, count) => number.toFixed(count);

const PAPER = 1; // links of version 1 mean the paper's procedure

/** @param {{ core: any, instance: any, source: (path: string) => Promise<any> }} bench the bench core, the same with the API of the app, and modules of the app */
export async function benchBunch({ core, instance, source }) {
	const { writeContainer } = await source("web/src/core/container.ts");
	const { readBunchPlant } = await source("web/src/models/bunch/read_bunch_plant.ts");
	const { encodeRequest: blocksOf } = await source("web/src/models/bunch/request.ts");
	const { PRESETS } = await source("web/src/models/bunch/presets/presets.ts");
	const { specimenFromPreset } = await source("web/src/models/bunch/schema.ts");
	/** A request as the bytes that the core receives. */
	const encodeRequest = (specimen, options) => writeContainer(blocksOf(specimen, options));
	const reader = { grow: (request) => readBunchPlant(instance.growBytes(request)) };
	const ratios = [];

	ratios.push(...benchNatural({ core, reader, encodeRequest, presets: PRESETS, specimenFromPreset }));
	benchPresets();
	benchTable2();
	benchKernels();
	benchScale();
	console.log(
		`\nwasm / native, geometric mean of ${ratios.length}: ${digits(geometricMean(ratios), 2)} (aim 1.35 at the most)`,
	);

	/** Wasm and native microseconds of one request, and their ratio. */
	function timeGrow(request) {
		const wasm = microseconds(20, RUNS, grower(core, request));
		const native = nativeGrow(request, 20, RUNS);
		return { wasm, native, ratio: wasm / native };
	}

	function benchPresets() {
		const rows = [
			["growing a preset", "internodes", "berries", "wasm µs", "native µs", "ratio", "with meshes µs", "vertices"],
		];
		for (const { name } of PRESETS.filter(({ kind }) => kind !== "variety")) {
			const specimen = specimenFromPreset(name, PAPER);
			const bare = encodeRequest(specimen, { meshes: false, measures: false });
			const whole = encodeRequest(specimen, { measures: false });
			const { counts, stem } = reader.grow(whole);
			const { wasm, native, ratio } = timeGrow(bare);
			const meshed = microseconds(10, RUNS, grower(core, whole));
			ratios.push(ratio);
			rows.push([
				name,
				counts.internodes,
				counts.berries,
				digits(wasm, 0),
				digits(native, 0),
				digits(ratio, 2),
				digits(meshed, 0),
				stem.positions.length / 3,
			]);
		}
		printTable(`The paper's procedure, medians of ${RUNS} runs of 20 (aim: the largest in about 1000 µs)`, rows);
	}

	function benchTable2() {
		const rows = [["paper: internodes", "berries", "ms", "ours: radius", "internodes", "berries", "wasm ms"]];
		RADII.forEach((radius, i) => {
			const grown = Array.from({ length: 20 }, (_, seed) => {
				const specimen = specimenFromPreset("shouldered-conical", PAPER);
				specimen.seed = seed + 1;
				Object.assign(specimen.parameters, { fit: 0, vary: 0, rmin: radius * 0.8, rmax: radius * 1.2 });
				const request = encodeRequest(specimen, { meshes: false, measures: false });
				return { counts: reader.grow(request).counts, time: microseconds(5, 3, grower(core, request)) };
			});
			const mean = (pick) => grown.reduce((sum, one) => sum + pick(one), 0) / grown.length;
			rows.push([
				...TABLE_2[i],
				radius,
				digits(
					mean(({ counts }) => counts.internodes),
					1,
				),
				digits(
					mean(({ counts }) => counts.berries),
					1,
				),
				digits(median(grown.map(({ time }) => time)) / 1000, 3),
			]);
		});
		printTable("Table 2 of the paper (2012, native) and shouldered conical as printed here, 20 seeds", rows);
	}

	/** A kernel both ways: microseconds of a round and its work. */
	function timeKernel(kernel, size, rounds) {
		core.panicle_bench(KERNELS[kernel], size, 0);
		const work = core.panicle_bench(KERNELS[kernel], size, 1);
		const wasm = microseconds(rounds, RUNS, (times) => core.panicle_bench(KERNELS[kernel], size, times));
		const native = nativeKernel(kernel, size, rounds, RUNS).microseconds;
		ratios.push(wasm / native);
		return { work, wasm, native, ratio: wasm / native };
	}

	function benchKernels() {
		const rows = [["kernel", "work", "wasm", "native", "unit", "ratio"]];
		const derive = timeKernel("derive", DERIVE_STEPS, 3);
		const rate = ({ work }, time) => digits(work / time, 1);
		rows.push([
			`derive, ${DERIVE_STEPS} steps`,
			derive.work,
			rate(derive, derive.wasm),
			rate(derive, derive.native),
			"M modules/s",
			digits(derive.ratio, 2),
		]);
		for (const spheres of [500, 10000]) {
			const probe = timeKernel("probe", spheres, spheres < 1000 ? 20 : 2);
			const each = (time) => digits(time / probe.work, 2);
			rows.push([
				`probe, ${spheres} spheres`,
				probe.work,
				each(probe.wasm),
				each(probe.native),
				"µs a sphere",
				digits(probe.ratio, 2),
			]);
		}
		const tubes = timeKernel("tubes", 199, 20);
		rows.push([
			"tubes, 12 sides",
			tubes.work,
			rate(tubes, tubes.wasm),
			rate(tubes, tubes.native),
			"M vertices/s",
			digits(tubes.ratio, 2),
		]);
		printTable("Kernels (aims: 200 M modules/s, 3 µs a sphere, 100 M vertices/s)", rows);

		const modules = peerModules(DERIVE_STEPS);
		const peer = modules / microseconds(1, 5, () => peerModules(DERIVE_STEPS));
		const ours = derive.work / derive.wasm;
		console.log(
			`lindenmayer (npm), same rule, ${modules} modules: ${digits(peer, 1)} M modules/s; ours / peer ${digits(ours / peer, 1)} (aim 10)`,
		);
	}

	function benchScale() {
		const rows = [["plan", "pedicels", "wasm ms", "native ms", "µs a pedicel", "ratio"]];
		for (const factor of [1, 10, 100]) {
			const { work, wasm, native, ratio } = timeKernel("plan", factor, factor > 10 ? 1 : 10);
			rows.push([
				`${factor} ×`,
				work,
				digits(wasm / 1000, 2),
				digits(native / 1000, 2),
				digits(wasm / work, 2),
				digits(ratio, 2),
			]);
		}
		printTable("Cost as the paper's plan grows", rows);
	}
}
