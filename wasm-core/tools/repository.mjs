/** Paths of the repository's folders and files, absolute. */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

export const repository = fileURLToPath(new URL("../..", import.meta.url)).replace(/[/\\]$/, "");
export const coreFolder = join(repository, "wasm-core");
/** The folder of everything that is built, except for dist/. */
export const buildFolder = join(repository, "build");
/** The folder of finished modules, which are complete at any time. */
export const modulesFolder = join(buildFolder, "core");
/** Modules that only tests and the bench load. */
export const testModulesFolder = join(buildFolder, "core-test");
/** The file of a module. */
export const moduleOf = (name) => join(modulesFolder, `${name}.wasm`);

/** Names of the modules of the core, sorted: a model's own name, or that of its family, whose models share a module. */
export function moduleNames() {
	const folder = join(coreFolder, "parameters");
	const tables = readdirSync(folder)
		.filter((name) => /^[a-z]+\.json$/.test(name))
		.map((name) => JSON.parse(readFileSync(join(folder, name), "utf8")));
	const models = tables.filter((table) => table.model);
	return [...new Set(models.map(({ model, family }) => family ?? model))].sort();
}
