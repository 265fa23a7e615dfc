/** Where things are. Paths are absolute. */
import { join } from "node:path";
import { fileURLToPath } from "node:url";

export const repository = fileURLToPath(new URL("../..", import.meta.url)).replace(/[/\\]$/, "");
export const coreFolder = join(repository, "wasm-core");
/** Everything that is built but for dist/. */
export const buildFolder = join(repository, "build");
/** The finished modules; what is here is always whole. */
export const modulesFolder = join(buildFolder, "core");
export const coreModule = join(modulesFolder, "panicle.wasm");
