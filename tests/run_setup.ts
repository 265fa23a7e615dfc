/** Runs once before all of vitest's tests. */
import type { TestProject } from "vitest/node";
import { buildCore, CoreBuildError } from "../wasm-core/tools/core.mjs";
import { isLongRun } from "./long_run.mjs";

declare module "vitest" {
	interface ProvidedContext {
		/** Of fast-check, in every file. */
		propertySeed?: number;
	}
}

/**
 * Generates code and builds the core, so that tests never run on old ones. When the core does not compile, the tests run on
 * the last one that did; `npm test` itself stops before.
 */
async function buildModules(): Promise<void> {
	try {
		await buildCore("wasm", ["models", "toy"]);
	} catch (error) {
		if (!(error instanceof CoreBuildError)) throw error;
		console.error(`The core does not compile. These tests run on the last core that did.\n${error.message}`);
	}
}

/** The seed of property tests: fixed in the gate, random in the long run. `PANICLE_SEED=17` repeats a run. */
function chooseSeed(): number {
	const given = process.env.PANICLE_SEED;
	const seed = given ? Number(given) : isLongRun ? Math.floor(Math.random() * 2 ** 31) : 1;
	if (!Number.isInteger(seed)) throw new Error(`PANICLE_SEED=${given} is not a whole number.`);
	if (given || isLongRun) console.log(`Property tests run with seed ${seed}; PANICLE_SEED=${seed} repeats this.`);
	return seed;
}

let seed: number | undefined;

export default async function setup({ provide }: TestProject): Promise<void> {
	// vitest calls this for each of its projects.
	if (seed === undefined) await buildModules();
	seed ??= chooseSeed();
	provide("propertySeed", seed);
}
