import { buildCore } from "../wasm-core/tools/core.mjs";

/** Before any test that grows: the core as its sources are now. */
export default async function setup(): Promise<void> {
	await buildCore();
}
