import { coreAddress } from "../core/core_address";

/** The address of a model's core, by its file: `bunch.wasm`. */
export function addressOf(wasm: string): string {
	const address = coreAddress(wasm);
	if (address === undefined) throw new Error(`There is no core ${wasm}.`);
	return address;
}
