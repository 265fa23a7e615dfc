/**
 * `npm run release`: makes build/release/VERSION out of what is committed: the app, the package for npm, what has changed, and their sums
 * (SHA-256; `sha256sum -c SHA256SUMS`). Publishes nothing. `npm run release -- --sizes` comes before, ahead of the commit of the version: it records
 * the sizes of the release, and prints the rises that the changelog has to state.
 */
import { join } from "node:path";
import { buildCore } from "./core.mjs";
import { makePackage, manifest } from "./package/make.mjs";
import { writeRelease } from "./release/release.mjs";
import { buildFolder, repository } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";
import { ToolchainError } from "./toolchain.mjs";

/** A module of tests/sizes, which are no part of this project of TypeScript. */
const sizes = (module) => import(new URL(`../../tests/sizes/${module}`, import.meta.url).href);

async function app() {
	await buildCore();
	const { build } = await import("vite");
	await build({ configFile: join(repository, "vite.config.ts"), logLevel: "error" });
	return join(repository, "dist");
}

async function recordSizes(version) {
	await app();
	await makePackage();
	const { recordSizes: record } = await sizes("record.mjs");
	const rises = await record(version, new Date().toISOString().slice(0, 10));
	console.log("Sizes are recorded in tests/sizes/last_release.json.");
	if (rises.length === 0) return;
	const where = `CHANGELOG.md, section [${version}], under “### Sizes”`;
	console.log(`State these with their reasons in ${where}:\n\n${rises.join("\n")}`);
}

async function release(version) {
	const { lastRelease } = await sizes("check.mjs");
	const { version: recorded } = lastRelease();
	if (recorded !== version) {
		throw new ToolchainError(
			`release: tests/sizes/last_release.json has the sizes of ${recorded}; run \`npm run release -- --sizes\` and commit.`,
		);
	}
	const out = join(buildFolder, "release", version);
	const make = { app, tarball: async () => (await makePackage()).tarball };
	for (const file of await writeRelease({ root: repository, out, make })) console.log(join(out, file));
}

await command(async () => {
	const { version } = manifest();
	const records = process.argv.includes("--sizes");
	await setUp(records ? "test" : "core");
	await (records ? recordSizes(version) : release(version));
});
