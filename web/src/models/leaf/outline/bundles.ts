/**
 * Indices in bundles of like width, on a logarithmic scale from the finest to the widest; none is empty. What draws veins
 * draws a bundle at a time: a stroke for each would cost more than growing them.
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
