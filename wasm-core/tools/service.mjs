/**
 * `npm run service`: builds what is missing, bundles the model service into one file, and runs it. `--build` only
 * bundles, and prints the file.
 */
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { buildCore } from "./core.mjs";
import { withLock } from "./lock.mjs";
import { bundleForNode } from "./node_bundle.mjs";
import { buildFolder } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";

const folder = join(buildFolder, "node/service");
const program = join(folder, "panicle-service.mjs");

await command(async () => {
	await setUp("core");
	await buildCore();
	await withLock(join(buildFolder, "service.lock"), () =>
		bundleForNode({ "panicle-service": "service/node/main.ts" }, folder, { alone: true }),
	);
});
if (process.argv.includes("--build")) console.log(program);
else await import(pathToFileURL(program).href);
