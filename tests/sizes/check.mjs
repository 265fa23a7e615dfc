/**
 * Compares the sizes of the built app with those of the last release (last_release.json): the stage `sizes` of `npm test`. A row may be
 * 2 % larger, or as large as the changelog states.
 */
import { readFileSync } from "node:fs";
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
 * @returns {{ table: string, advice: string }} advice: how to handle rows that are too large; empty where there are none
 * @throws Error where the app or a core is not built
 */
export function checkSizes() {
	const last = lastRelease();
	const { table, problems } = compare(measure(), last, { stated: stated(last), emscripten: compilerVersion() });
	const advice = [
		"These are over 2 % larger than in the last release. Make them smaller, or state them with the reason in CHANGELOG.md,",
		"section [Unreleased], under “### Sizes”:",
		...problems,
	];
	return { table, advice: problems.length > 0 ? advice.join("\n") : "" };
}
