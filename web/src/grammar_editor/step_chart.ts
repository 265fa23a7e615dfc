/** Chart of the number of modules of each step, for a slider: logarithmic, because strings grow by factors. */

/** Height of the chart; its width is 100. */
export const CHART_HEIGHT = 24;
/** With more steps than this, each point of the chart is the maximum of several steps. */
const MAX_PLACES = 400;

/** Returns the chart of the steps from the first one up to `to`, as an SVG path; empty if there is nothing to draw. */
export function stepChart(counts: ArrayLike<number>, to = counts.length - 1): string {
	const last = counts.length - 1;
	if (last < 1 || to < 0) return "";
	let most = 1;
	for (let step = 0; step <= last; step++) most = Math.max(most, counts[step]);
	const height = (count: number) =>
		CHART_HEIGHT * (1 - (0.08 + (0.92 * Math.log(Math.max(1, count))) / Math.log(Math.max(2, most))));
	const stride = Math.max(1, Math.ceil(last / MAX_PLACES));
	const points: string[] = [];
	for (let step = 0; step <= to; step += stride) {
		let tallest = 0;
		for (let each = step; each < Math.min(step + stride, last + 1); each++) tallest = Math.max(tallest, counts[each]);
		points.push(`${round((100 * step) / last)} ${round(height(tallest))}`);
	}
	const end = round((100 * to) / last);
	points.push(`${end} ${round(height(counts[to]))}`);
	return `M0 ${CHART_HEIGHT}L${points.join("L")}L${end} ${CHART_HEIGHT}Z`;
}

/** Rounds to hundredths, to shorten the path. */
const round = (value: number) => Math.round(value * 100) / 100;
