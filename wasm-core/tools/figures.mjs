/**
 * Numbers in the documentation that programs measure: `<!-- figure: NAME -->172 kB<!-- /figure -->` in a line of a
 * page. Sizes have the names of the rows of `npm test -- sizes`; counts have the names in tests/sizes/counts.ts. A
 * figure in code, behind a backtick, is none.
 */

/** A size in a page may differ by this share from the measured one. */
const TOLERANCE = 0.02;

const FIGURE = /(?<!`)<!-- figure: (.+?) -->(.*?)<!-- \/figure -->/g;

const UNITS = { MB: 1e6, kB: 1e3 };

/**
 * @typedef {object} Figure
 * @property {number} value bytes, or a count
 * @property {boolean} [exact] whether a page must show exactly this value
 */

/** The number that a page shows, and its unit: "8.5 MB", "1,204". */
function read(text) {
	const [, digits, unit] = /^([\d.,]+) ?(MB|kB)?$/.exec(text) ?? [];
	return {
		value: Number((digits ?? "").replaceAll(",", "")) * (UNITS[unit] ?? 1),
		unit,
		isNumber: digits !== undefined,
	};
}

/** The value in the unit that the page uses, with three significant digits where there is a unit. */
function write(value, unit) {
	if (!unit) return value.toLocaleString("en");
	return `${Number((value / UNITS[unit]).toPrecision(3)).toLocaleString("en")} ${unit}`;
}

/** The unit of a new figure: none for counts. @param {Figure} figure */
const unitOf = ({ value, exact }) => (exact || value < 1e3 ? undefined : value < 1e6 ? "kB" : "MB");

/**
 * Returns the page with its figures brought up to date. A size that differs by at most 2 % is left as it is, and so is a figure whose value is not
 * known, such as a size of an app that is not built.
 * @param {string} page
 * @param {ReadonlyMap<string, Figure>} figures by name
 * @param {(name: string) => boolean} isKnown whether a name can have a value at all
 * @throws Error where a name is unknown, or a line begins with a figure, which Markdown takes for a block of HTML
 */
export function withFigures(page, figures, isKnown = (name) => figures.has(name)) {
	const first = /^ *<!-- figure: (.+?) -->/m.exec(page);
	if (first) throw new Error(`A line begins with the figure “${first[1]}”; put a word before it.`);
	return page.replace(FIGURE, (whole, name, text) => {
		if (!isKnown(name)) throw new Error(`There is no figure “${name}”.`);
		const figure = figures.get(name);
		if (!figure) return whole;
		const { value, unit, isNumber } = read(text);
		const tolerance = figure.exact ? 0 : TOLERANCE * figure.value;
		if (isNumber && Math.abs(value - figure.value) <= tolerance) return whole;
		return `<!-- figure: ${name} -->${write(figure.value, isNumber ? unit : unitOf(figure))}<!-- /figure -->`;
	});
}
