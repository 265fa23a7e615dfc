/**
 * `npm run release`: builds the committed version into build/release/VERSION: the app, the npm package, its changelog
 * and SHA-256 checksums. Publishes nothing. Before the commit of a version, run `npm run release -- --sizes`: it
 * records the sizes and prints the rises that the changelog has to state.
 */
import { join } from "node:path";
import { buildCore } from "./core.mjs";
import { makePackage, manifest } from "./package/make.mjs";
import { writeRelease } from "./release/release.mjs";
import { buildFolder, repository } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";
import { ToolchainError } from "./toolchain.mjs";

/** Imports a module of tests/sizes, which this TypeScript project does not include. */
const sizes = (module) => import(new URL(`../../tests/sizes/${module}`, import.meta.url).href);

async function app() {
	await buildCore();
	const { build } = await import("vite");
	await build({ configFile: join(repository, "vite.config.ts"), logLevel: "error" });
	return join(repository, "dist");
}

/** Builds the app and the package, records their sizes, and prints the rises since the last release. */
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

/**
 * Builds the files of a version.
 * @throws ToolchainError if the recorded sizes are those of another version
 */
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
