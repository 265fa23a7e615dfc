import { coreAddress } from "../core/core_address";

/** Where a model's core lies, by its file: `bunch.wasm`. */
export function addressOf(wasm: string): string {
	const address = coreAddress(wasm);
	if (address === undefined) throw new Error(`There is no core ${wasm}.`);
	return address;
}
