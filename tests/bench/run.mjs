/**
 * `npm run bench [-- NAME]`: times of core, page and service, as medians and as ratios (docs/speed.md). Ratios can be
 * compared between machines, times cannot. Without a name it runs all but `fit`, `soak`, `stand` and `use`. Only
 * `soak` and `use` can fail.
 */
import { join } from "node:path";
import { buildCore } from "../../wasm-core/tools/core.mjs";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { command, setUp } from "../../wasm-core/tools/setup.mjs";
import { runTask } from "../../wasm-core/tools/tasks.mjs";

/** The core for benchmarks, loaded when the first of them begins. */
let loaded;
const onCore = () => {
	loaded ??= loadCore();
	return loaded;
};

async function loadCore() {
	const { runnerImport } = await import("vite");
	const { benchModule, loadBenchCore } = await import("./core.mjs");
	const source = async (path) => (await runnerImport(join(repository, path))).module;
	const core = await loadBenchCore();
	const { Core } = await source("web/src/core/core.ts");
	return { core, instance: await Core.instantiate(benchModule()), source };
}

/** @type {Record<string, import("../../wasm-core/tools/tasks.mjs").Task>} */
const RUNS = {
	core: {
		about: "bunches and the kernels of the core, as wasm and natively",
		run: async () => (await import("./bunch.mjs")).benchBunch(await onCore()),
	},
	particles: {
		about: "leaves, trees and roots",
		run: async () => (await import("./particles.mjs")).benchParticles(await onCore()),
	},
	maps: {
		about: "generalized maps",
		run: async () => (await import("./maps.mjs")).benchMaps(await onCore()),
	},
	topiary: {
		about: "trees clipped to growth areas",
		run: async () => (await import("./topiary.mjs")).benchTopiaries(await onCore()),
	},
	grammar: {
		about: "texts of L-systems",
		run: async () => (await import("./grammar.mjs")).benchGrammar(await onCore()),
	},
	growth: {
		about: "trees by divisor functions",
		run: async () => (await import("./growth.mjs")).benchGrowth(await onCore()),
	},
	flower: {
		about: "flowers",
		run: async () => (await import("./flower.mjs")).benchFlowers(await onCore()),
	},
	proportion: {
		about: "time and memory of every model from its usual size to the largest",
		run: async () => (await import("./proportion.mjs")).benchProportion(),
	},
	service: {
		about: "bunches per second that the model service answers as JSON",
		run: async () => (await import("./service.mjs")).benchService(),
	},
	browser: {
		about: "the page: its size, its start, a drag",
		run: async () => (await import("./browser.mjs")).benchBrowser(),
	},
	page: {
		about: "texts in the built page, or in one built before",
		words: "[FOLDER]",
		run: async ([folder]) => (await import("./page.mjs")).benchPage(folder),
	},
	frame: {
		about: "drawing alone, of the built page or of one built before",
		words: "[FOLDER]",
		run: async ([folder]) => (await import("./frame.mjs")).benchFrame(folder),
	},
	watching: {
		about: "a life of particles in the page, played from start to end",
		words: "[MODEL/PRESET …]",
		run: async (plants) => (await import("./watching.mjs")).benchWatching(plants),
	},
	stand: {
		about: "stands of up to 2,000 trees, in wasm and in the built page",
		run: async () => (await import("./stand.mjs")).benchStand(),
	},
	fit: {
		about: "how closely bunches follow their handles (`npm run docs -- fit` writes docs/measuring.md)",
		run: async () => console.log((await import("./fit.mjs")).fitTable()),
	},
	soak: {
		about: "the memory of the model service over 100,000 requests; fails if it grows",
		words: "[REQUESTS]",
		run: async ([requests]) => {
			const { failed } = await (await import("./soak.mjs")).soak(requests);
			if (failed > 0) process.exitCode = 1;
		},
	},
	use: {
		about: "the built page under random use for ten minutes; fails at an error, a blocked thread or growth",
		words: "[ACTIONS | NUMBER NUMBER …]",
		run: async (numbers) => {
			const { failed } = await (await import("../random_use/random_use.mjs")).randomUse(...numbers);
			if (failed > 0) process.exitCode = 1;
		},
	},
};

/** Runs that are made by name alone: they take long, or have other pages in the documentation. */
const BY_NAME = ["stand", "fit", "soak", "use"];

const words = process.argv.slice(2);
if (words[0] !== "--help") {
	await command(async () => {
		await setUp("core");
		await buildCore();
	});
}
const standard = async () => {
	for (const [name, { run }] of Object.entries(RUNS)) if (!BY_NAME.includes(name)) await run([]);
};
await runTask("bench", RUNS, words, { standard });
