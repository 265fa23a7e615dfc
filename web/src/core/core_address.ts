import { coreFiles } from "./core_files";

/**
 * Returns the address of a core: of a built file by its name (`bunch.wasm`), or `file` itself if it is an address; else
 * undefined.
 */
export function coreAddress(file: string): string | undefined {
	return coreFiles[`../../../build/core/${file}`] ?? (URL.canParse(file) ? file : undefined);
}
