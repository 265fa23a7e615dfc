/** Where things are. Paths are absolute. */
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

export const repository = fileURLToPath(new URL("../..", import.meta.url)).replace(/[/\\]$/, "");
export const coreFolder = join(repository, "wasm-core");
/** Everything that is built but for dist/. */
export const buildFolder = join(repository, "build");
/** The finished modules; what is here is always whole. */
export const modulesFolder = join(buildFolder, "core");
/** Modules that only tests and the bench load. */
export const testModulesFolder = join(buildFolder, "core-test");
/** The module that is linked of a folder of models. */
export const moduleOf = (folder) => join(modulesFolder, `${folder}.wasm`);
/** The folders of models: each holds one, or a family of them, and is a module. */
export const modelFolders = () => readdirSync(join(coreFolder, "src/models")).sort();
