/** Records the sizes of a release in last_release.json, and keeps those of the release before, so that rises can be stated. */
import { rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { run } from "../../wasm-core/tools/process.mjs";
import { repository } from "../../wasm-core/tools/repository.mjs";
import { freePort } from "../free_port.mjs";
import { lastRelease } from "./check.mjs";
import { lineFor, risen } from "./compare.mjs";
import { compilerVersion, measure, measuredFile } from "./measure.mjs";

/** Runs the end-to-end tests that measure sizes: their titles have the tag @sizes. */
async function measureInBrowser() {
	rmSync(dirname(measuredFile("")), { recursive: true, force: true });
	const env = { ...process.env, PANICLE_LONG: "1", PANICLE_SIZES: "record", PANICLE_PORT: String(await freePort()) };
	const cli = join(repository, "node_modules/@playwright/test/cli.js");
	const args = [cli, "test", "--grep", "@sizes", "--reporter", "line"];
	const { status } = await run(process.execPath, args, { cwd: repository, env, show: process.stderr });
	if (status !== 0) throw new Error("The end-to-end tests that measure sizes failed; see above.");
}

/**
 * Measures the build and writes last_release.json.
 * @param {string} version
 * @param {string} date as in the changelog: 2026-01-31
 * @returns {Promise<string[]>} a line for each row that rose by more than 2 %, for the changelog
 */
export async function recordSizes(version, date) {
	await measureInBrowser();
	const { previous, ...last } = lastRelease();
	const sizes = measure();
	const missing = Object.keys(last.sizes).filter((row) => !(row in sizes));
	if (missing.length > 0) throw new Error(`These rows of the last release were not measured: ${missing.join("; ")}.`);
	const recorded = {
		version,
		date,
		emscripten: compilerVersion(),
		sizes,
		// Recorded again, a release keeps the one before it.
		previous: last.version === version ? previous : last,
	};
	const file = fileURLToPath(new URL("last_release.json", import.meta.url));
	writeFileSync(file, `${JSON.stringify(recorded, null, "\t")}\n`);
	return risen(recorded).map(({ row, before, now }) => lineFor(row, before, now));
}
