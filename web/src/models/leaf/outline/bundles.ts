/**
 * Groups indices by similar width, on a logarithmic scale from the thinnest to the widest; no group is empty. Veins
 * are drawn group by group: a stroke for each vein would take longer than growing the veins.
 * @param count most groups
 * @returns the indices of each group, the thinnest group first
 */
export function bundled(widths: ArrayLike<number>, count: number): number[][] {
	const logs = Array.from(widths, (width) => Math.log(Math.max(width, 1e-9)));
	let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
	for (const value of logs) [low, high] = [Math.min(low, value), Math.max(high, value)];
	const bundles = Array.from({ length: count }, (): number[] => []);
	logs.forEach((value, index) => {
		const share = high > low ? (value - low) / (high - low) : 0;
		bundles[Math.min(count - 1, Math.floor(share * count))].push(index);
	});
	return bundles.filter((members) => members.length > 0);
}
