/**
 * `node tests/sizes/check.mjs`: compares the sizes of the built app with those of the last release (last_release.json), prints the table, and fails
 * where a row is over 2 % larger and the changelog does not state it.
 */
import { readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { compare, limitOf, statedSince } from "./compare.mjs";
import { compilerVersion, measure } from "./measure.mjs";

/** @returns {import("./compare.mjs").Recorded} */
export const lastRelease = () => JSON.parse(readFileSync(new URL("last_release.json", import.meta.url), "utf8"));

const changelog = () => readFileSync(new URL("../../CHANGELOG.md", import.meta.url), "utf8");
const stated = ({ version }) => statedSince(changelog(), version);

/** The size that a row may have; undefined where the last release does not have the row. */
export function sizeLimit(row) {
	const last = lastRelease();
	return limitOf(row, last, stated(last));
}

/**
 * @returns {{ table: string, problems: string[] }} problems: the lines that the changelog would have to state
 * @throws Error where the app or a core is not built
 */
export function checkSizes() {
	const last = lastRelease();
	return compare(measure(), last, { stated: stated(last), emscripten: compilerVersion() });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
	const { table, problems } = checkSizes();
	console.log(table);
	if (problems.length > 0) {
		console.log(
			[
				"\nThese are over 2 % larger than in the last release. Make them smaller, or state them with the reason in CHANGELOG.md,",
				"section [Unreleased], under “### Sizes”:\n",
				...problems,
			].join("\n"),
		);
		process.exitCode = 1;
	}
}
