import { buildCore, CoreBuildError } from "../wasm-core/tools/core.mjs";

/**
 * Before any test: the core as its sources are now. While it does not compile, tests that grow use the last one that
 * did and the others stand; `npm test` itself stops before.
 */
export default async function setup(): Promise<void> {
	try {
		await buildCore();
	} catch (error) {
		if (!(error instanceof CoreBuildError)) throw error;
		console.error(`The core does not build; what grows below is the last one that did.\n${error.message}`);
	}
}
