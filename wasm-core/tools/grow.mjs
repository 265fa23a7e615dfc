/**
 * `npm run -s grow -- …`: grows a bunch without a page. Makes what is missing, talking to standard error only, and
 * then hands over to the command in web/src/cli, bundled for Node.
 */
import { existsSync, readdirSync, statSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { buildCore } from "./core.mjs";
import { withLock } from "./lock.mjs";
import { buildFolder, repository } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";

const sources = join(repository, "web/src");
// As deep in the repository as web/src/cli, so that relative addresses of the core hold in both places.
const folder = join(buildFolder, "node/cli");
const program = join(folder, "main.mjs");

function isFresh() {
	if (!existsSync(program)) return false;
	const made = statSync(program).mtimeMs;
	const files = readdirSync(sources, { recursive: true }).map((name) => join(sources, name));
	return [...files, join(repository, "package-lock.json")].every((file) => statSync(file).mtimeMs < made);
}

async function bundle() {
	const { build } = await import("vite");
	await build({
		root: repository,
		configFile: false,
		publicDir: false,
		logLevel: "silent",
		build: {
			ssr: join(sources, "cli/main.ts"),
			outDir: folder,
			emptyOutDir: true,
			target: "node20",
			rolldownOptions: { output: { entryFileNames: "main.mjs" } },
		},
	});
}

await command(async () => {
	await setUp("core");
	await buildCore();
	await withLock(join(buildFolder, "cli.lock"), async () => {
		if (!isFresh()) await bundle();
	});
});
await import(pathToFileURL(program).href);
