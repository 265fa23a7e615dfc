/**
 * `npm run release`: makes build/release/VERSION out of what is committed: the app, the package for npm, what has changed, and their sums
 * (SHA-256; `sha256sum -c SHA256SUMS`). Publishes nothing.
 */
import { join } from "node:path";
import { buildCore } from "./core.mjs";
import { makePackage, manifest } from "./package/make.mjs";
import { writeRelease } from "./release/release.mjs";
import { buildFolder, repository } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";

await command(async () => {
	await setUp("core");
	const out = join(buildFolder, "release", manifest().version);
	const make = {
		app: async () => {
			await buildCore();
			const { build } = await import("vite");
			await build({ configFile: join(repository, "vite.config.ts"), logLevel: "error" });
			return join(repository, "dist");
		},
		tarball: async () => (await makePackage()).tarball,
	};
	for (const file of await writeRelease({ root: repository, out, make })) console.log(join(out, file));
});
