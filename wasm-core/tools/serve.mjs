/** `npm run serve`: makes what is missing, bundles the model service into one file, and runs it. `--build` only bundles. */
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { buildCore } from "./core.mjs";
import { withLock } from "./lock.mjs";
import { buildFolder, repository } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";

const folder = join(buildFolder, "node/service");
const program = join(folder, "panicle-service.mjs");

async function bundle() {
	const { build } = await import("vite");
	await build({
		root: repository,
		configFile: false,
		publicDir: false,
		logLevel: "silent",
		ssr: { noExternal: true },
		assetsInclude: ["**/*.wasm"],
		build: {
			ssr: join(repository, "web/src/service/node/main.ts"),
			outDir: folder,
			emptyOutDir: true,
			target: "node20",
			rolldownOptions: { output: { entryFileNames: "panicle-service.mjs", codeSplitting: false } },
		},
	});
}

await command(async () => {
	await setUp("core");
	await buildCore();
	await withLock(join(buildFolder, "service.lock"), bundle);
});
if (process.argv.includes("--build")) console.log(program);
else await import(pathToFileURL(program).href);
