#!/usr/bin/env node
/**
 * `npm run -s grow -- …`, or `npx panicle …` in a clone: grows a plant without a page. Builds what is missing, with
 * messages on standard error only, and then runs the command line in web/src/cli, bundled for Node.
 */
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { buildCore } from "./core.mjs";
import { filesIn, isFresh, remember } from "./fresh.mjs";
import { withLock } from "./lock.mjs";
import { bundleForNode } from "./node_bundle.mjs";
import { buildFolder } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";

// As deep in the repository as web/src/cli, so that relative addresses of the core hold in both places.
const folder = join(buildFolder, "node/cli");
const program = join(folder, "main.mjs");
const madeFrom = join(folder, "made_from.txt");

await command(async () => {
	await setUp("core");
	await buildCore();
	await withLock(join(buildFolder, "cli.lock"), async () => {
		const inputs = filesIn("web/src", "package.json", "package-lock.json");
		if (isFresh(program, madeFrom, inputs)) return;
		await bundleForNode({ main: "cli/main.ts" }, folder);
		remember(madeFrom, inputs);
	});
});
await import(pathToFileURL(program).href);
