/**
 * The core as the bench sees it: core-bench.wasm in this process and core_bench_native beside it, the same sources
 * and the same kernels (wasm-core/bench/kernels.hpp).
 */
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { buildCore } from "../../wasm-core/tools/core.mjs";
import { buildFolder, testModulesFolder } from "../../wasm-core/tools/repository.mjs";
import { median } from "./statistics.mjs";

export const KERNELS = {
	derive: 0,
	plan: 1,
	probe: 2,
	tubes: 3,
	crowd_flat: 4,
	crowd_space: 5,
	brute_flat: 6,
	brute_space: 7,
	colonise_flat: 8,
	colonise_space: 9,
	derive_chance: 10,
	derive_context: 11,
	map_build: 12,
	map_check: 13,
	map_embed: 14,
	map_place: 15,
	growth_text: 16,
	growth_population: 17,
	growth_form: 18,
	growth_moment: 19,
	growth_leaves: 20,
	growth_levels: 21,
};

export async function loadBenchCore() {
	await buildCore("wasm", ["all"]);
	await buildCore("release", ["core_bench_native"]);
	const module = benchModule();
	const imports = {};
	for (const { module: room, name } of WebAssembly.Module.imports(module)) {
		imports[room] ??= {};
		imports[room][name] = () => 0;
	}
	const core = new WebAssembly.Instance(module, imports).exports;
	core._initialize?.();
	return core;
}

/** The module that loadBenchCore has built. */
export function benchModule() {
	return new WebAssembly.Module(readFileSync(join(testModulesFolder, "core-bench.wasm")));
}

/** Copies a request in; gives a function that grows it `rounds` times. */
export function grower(core, request) {
	const at = core.panicle_allocate(request.length);
	new Uint8Array(core.memory.buffer, at, request.length).set(request);
	return (rounds) => {
		for (let i = 0; i < rounds; i++) core.panicle_release(core.panicle_grow(at, request.length));
	};
}

const native = join(buildFolder, "release", "core_bench_native");

/** Native microseconds of a kernel's round, and its work. */
export function nativeKernel(kernel, size, rounds, runs) {
	const output = execFileSync(native, [KERNELS[kernel], size, rounds, runs].map(String), { encoding: "utf8" });
	const { microseconds, work } = JSON.parse(output);
	return { microseconds: median(microseconds), work };
}

/** Native microseconds of growing one request. */
export function nativeGrow(request, rounds, runs) {
	const output = execFileSync(native, ["grow", String(rounds), String(runs)], { input: request, encoding: "utf8" });
	return median(JSON.parse(output).microseconds);
}
