import { buildCore, CoreBuildError } from "../wasm-core/tools/core.mjs";
import { generateCode } from "../wasm-core/tools/generate/files.mjs";

/**
 * Generates code and builds the core before any test, so that tests never run on old ones. `PANICLE_CORE=built`
 * skips the build where the caller has just built the core. When the core does not compile, the tests run on the last one
 * that did; `npm test` itself stops before.
 */
export default async function setup(): Promise<void> {
	generateCode();
	if (process.env.PANICLE_CORE === "built") return;
	try {
		await buildCore();
	} catch (error) {
		if (!(error instanceof CoreBuildError)) throw error;
		console.error(`The core does not compile. These tests run on the last core that did.\n${error.message}`);
	}
}
