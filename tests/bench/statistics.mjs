/** The middle of the numbers; of two middles, their mean. */
export function median(numbers) {
	const sorted = [...numbers].sort((a, b) => a - b);
	const half = sorted.length >> 1;
	return sorted.length % 2 ? sorted[half] : (sorted[half - 1] + sorted[half]) / 2;
}

/** Each factor counts alike, however small. */
export function geometricMean(ratios) {
	return Math.exp(ratios.reduce((sum, ratio) => sum + Math.log(ratio), 0) / ratios.length);
}

/**
 * Median microseconds of one call of `work(rounds)` per round, over `runs` runs after one to warm up; CPU time of this
 * process, on which other load has little effect.
 */
export function microseconds(rounds, runs, work) {
	work(rounds);
	return median(
		Array.from({ length: runs }, () => {
			const before = process.cpuUsage();
			work(rounds);
			const { user, system } = process.cpuUsage(before);
			return (user + system) / rounds;
		}),
	);
}

/** Prints a table: the first row its heads, numbers to the right. */
export function printTable(title, rows) {
	const text = rows.map((row) => row.map(String));
	const widths = text[0].map((_, column) => Math.max(...text.map((row) => row[column].length)));
	const line = (row) => row.map((cell, i) => (i ? cell.padStart(widths[i]) : cell.padEnd(widths[i]))).join("  ");
	console.log(`\n${title}`);
	console.log(text.map(line).join("\n"));
}
