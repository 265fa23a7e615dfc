/** `npm run build`: sets up what is missing and writes dist/, for any sub-path of any static host. */
import { join } from "node:path";
import { buildCore } from "./core.mjs";
import { repository } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";

await command(async () => {
	await setUp("core");
	await buildCore();
	const { build } = await import("vite");
	await build({ configFile: join(repository, "vite.config.ts") });
});
