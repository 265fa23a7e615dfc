/** Compares sizes with those of the last release. Pure: all that it needs is passed to it. */

/** Tolerated growth of a row, as a share. */
const SHARE = 0.02;
/** Tolerated growth in bytes, for small files. */
const SLACK = 256;

/**
 * @typedef {object} Release
 * @property {string} version
 * @property {string} emscripten the version of the compiler that made the cores
 * @property {Record<string, number>} sizes by row: bytes, or a number of files
 *
 * @typedef {Release & { date: string, previous?: Release }} Recorded the last release, and the one before it
 */

const isCount = (row) => row.startsWith("number of");
const limit = (row, size) => size * (1 + SHARE) + (isCount(row) ? 0 : SLACK);

/** Whether a row depends on the compiler: rows of different compilers are not compared. */
export const isOfCompiler = (row) => row.includes(".wasm") || row === "package for npm";

const formatNumber = (number) => number.toLocaleString("en");
const unit = (row) => (isCount(row) ? "files" : "bytes");

/** The line by which a changelog's section states a rise. */
export const lineFor = (row, before, now) =>
	`- \`${row}\`: ${formatNumber(before)} → ${formatNumber(now)} ${unit(row)}: REASON`;

/** The sections of a changelog, by the names in their headings, in its order. */
function sectionsOf(changelog) {
	const parts = changelog.split(/^## \[(.+?)\].*$/m).slice(1);
	return Array.from({ length: parts.length / 2 }, (_, i) => ({ name: parts[2 * i], text: parts[2 * i + 1] }));
}

/** The rises that a section states under "### Sizes", by row. */
function statedIn(text) {
	const [, sizes = ""] = /^### Sizes$([\s\S]*?)(?=^### |$(?![\s\S]))/m.exec(text) ?? [];
	const lines = sizes.matchAll(/^- `(.+?)`: [\d,]+ → ([\d,]+) (?:bytes|files): (?!REASON)\S/gm);
	return Object.fromEntries([...lines].map(([, row, to]) => [row, Number(to.replaceAll(",", ""))]));
}

/**
 * The rises that the changelog states since the last release.
 * @param {string} changelog
 * @param {string} version of the last release
 * @returns {Record<string, number>} sizes by row
 */
export function statedSince(changelog, version) {
	const sections = sectionsOf(changelog);
	const last = sections.findIndex(({ name }) => name === version);
	const since = last >= 0 ? sections.slice(0, last) : sections.filter(({ name }) => name === "Unreleased");
	return Object.assign({}, ...since.reverse().map(({ text }) => statedIn(text)));
}

/**
 * The size that a row may have: 2 % over the last release, or over the size that the changelog states since. Undefined for a new row.
 * @param {Recorded} last
 * @param {Record<string, number>} stated
 */
export function limitOf(row, last, stated) {
	const before = last.sizes[row];
	return before === undefined ? undefined : limit(row, Math.max(before, stated[row] ?? 0));
}

/**
 * @param {Record<string, number>} now
 * @param {Recorded} last
 * @param {{ stated?: Record<string, number>, emscripten: string }} options emscripten: the compiler of `now`
 * @returns {{ table: string, problems: string[] }} a problem for each row that is too large
 */
export function compare(now, last, { stated = {}, emscripten }) {
	const other = emscripten !== last.emscripten;
	const problems = [];
	const rows = Object.entries(now).map(([row, size]) => {
		const before = last.sizes[row];
		if (before === undefined) return [row, formatNumber(size), "–", "new"];
		const change = `${size < before ? "−" : "+"}${(100 * Math.abs(size / before - 1)).toFixed(1)} %`;
		if (other && isOfCompiler(row))
			return [row, formatNumber(size), formatNumber(before), `${change} (other compiler)`];
		if (size <= (limitOf(row, last, stated) ?? size)) return [row, formatNumber(size), formatNumber(before), change];
		problems.push(lineFor(row, before, size));
		return [row, formatNumber(size), formatNumber(before), `${change} TOO LARGE`];
	});
	const gone = Object.keys(last.sizes).filter((row) => !(row in now));
	rows.push(...gone.map((row) => [row, "not measured", formatNumber(last.sizes[row]), ""]));
	return { table: formatTable([["", "now", last.version, "change"], ...rows]), problems };
}

function formatTable(rows) {
	const widths = [0, 1, 2].map((column) => Math.max(...rows.map((row) => row[column].length)));
	return rows
		.map(([row, now, before, change]) =>
			`  ${row.padEnd(widths[0])}  ${now.padStart(widths[1])}  ${before.padStart(widths[2])}  ${change}`.trimEnd(),
		)
		.join("\n");
}

/**
 * The rows that rose by more than 2 % from the release before to the last one.
 * @param {Recorded} last
 * @returns {{ row: string, before: number, now: number }[]}
 */
export function risen({ sizes, previous }) {
	return Object.entries(previous?.sizes ?? {})
		.map(([row, before]) => ({ row, before, now: sizes[row] }))
		.filter(({ row, before, now }) => now > limit(row, before));
}

/**
 * The lines that the changelog's section of the last release lacks: one for each row that rose.
 * @param {Recorded} last
 * @param {string} changelog
 */
export function missingLines(last, changelog) {
	const section = sectionsOf(changelog).find(({ name }) => name === last.version);
	const stated = statedIn(section?.text ?? "");
	return risen(last)
		.filter(({ row, now }) => !(now <= limit(row, stated[row] ?? 0)))
		.map(({ row, before, now }) => lineFor(row, before, now));
}
