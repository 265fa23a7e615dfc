/**
 * Grammars: modules per second for rules of three kinds, and a million modules derived, drawn and meshed, with the
 * time of each stage.
 */
import { grower, KERNELS, nativeGrow, nativeKernel } from "./core.mjs";
import { microseconds, printTable } from "./statistics.mjs";

/** Steps of each kernel: some million modules. */
const RULES = [
	["derive", "parametric", 16, 495],
	["derive_chance", "by chance", 10, 60],
	["derive_context", "in context", 36, 60],
];
const RUNS = 5;
/** 1,048,570 modules, 131,071 of them lines. */
const MILLION = "derivation length: 17\naxiom: A(1)\nA(s) --> F(s)[+(31)/(90)A(s/1.456)][-(29)A(s/1.456)]\n";

const milliseconds = (micro) => (micro / 1000).toFixed(0);

export async function benchGrammar({ core, source }) {
	benchRules(core);
	await benchMillion(core, source);
}

function benchRules(core) {
	const rows = [["rules", "steps", "modules written", "aim M/s", "wasm M modules/s", "native", "ratio"]];
	for (const [kernel, name, steps, aim] of RULES) {
		const work = core.panicle_bench(KERNELS[kernel], steps, 1);
		const wasm = microseconds(1, RUNS, () => core.panicle_bench(KERNELS[kernel], steps, 1));
		const native = nativeKernel(kernel, steps, 1, RUNS).microseconds;
		const rate = (time) => (work / time).toFixed(0);
		rows.push([name, steps, work, aim, rate(wasm), rate(native), (wasm / native).toFixed(2)]);
	}
	printTable("Deriving", rows);
}

async function benchMillion(core, source) {
	const { writeContainer } = await source("web/src/core/container.ts");
	const { fromPreset } = await source("web/src/specimen/from_preset.ts");
	const { model } = await source("web/src/models/grammar/index.ts");
	const specimen = { ...fromPreset(model), grammar: MILLION };
	const rows = [["a million modules", "aim ms", "wasm ms", "native ms", "ratio"]];
	for (const [name, options, aim] of [
		["derived and drawn", { meshes: false }, "–"],
		["and meshed, in passing", { preview: true }, "–"],
		["and meshed, with sky", {}, "400"],
	]) {
		const request = writeContainer(model.encode(specimen, options));
		const wasm = microseconds(1, RUNS, grower(core, request));
		const native = nativeGrow(request, 1, RUNS);
		rows.push([name, aim, milliseconds(wasm), milliseconds(native), (wasm / native).toFixed(2)]);
	}
	printTable("A text whole", rows);
}
