/**
 * `npm run -s grow -- …`: grows a plant without a page. Makes what is missing, talking to standard error only, and
 * then hands over to the command in web/src/cli, bundled for Node.
 */
import { existsSync, readdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import { pathToFileURL } from "node:url";
import { buildCore } from "./core.mjs";
import { withLock } from "./lock.mjs";
import { bundleForNode } from "./node_bundle.mjs";
import { buildFolder, repository } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";

const sources = join(repository, "web/src");
// As deep in the repository as web/src/cli, so that relative addresses of the core hold in both places.
const folder = join(buildFolder, "node/cli");
const program = join(folder, "main.mjs");
const madeFrom = join(folder, "made_from.txt");

/** What the bundle is made from; without folders, whose times change with the files in them. */
const inputs = [
	...readdirSync(sources, { recursive: true, withFileTypes: true })
		.filter((entry) => entry.isFile())
		.map((entry) => join(entry.parentPath, entry.name)),
	join(repository, "package.json"),
	join(repository, "package-lock.json"),
].sort();
const list = inputs.map((file) => relative(repository, file)).join("\n");

/** Made from the same files, and after the last of them changed: a file that moved in may be older than the bundle. */
function isFresh() {
	if (!existsSync(program) || !existsSync(madeFrom) || readFileSync(madeFrom, "utf8") !== list) return false;
	const made = statSync(program).mtimeMs;
	return inputs.every((file) => statSync(file).mtimeMs < made);
}

async function bundle() {
	await bundleForNode({ main: "cli/main.ts" }, folder);
	writeFileSync(madeFrom, list);
}

await command(async () => {
	await setUp("core");
	await buildCore();
	await withLock(join(buildFolder, "cli.lock"), async () => {
		if (!isFresh()) await bundle();
	});
});
await import(pathToFileURL(program).href);
