/** Coverage and spill for a bunch that is the octahedron of the handles itself. */

/** Whether a point lies within a polygon, by the even-odd rule. */
export function inside(polygon, x, y) {
	let odd = false;
	polygon.forEach((a, i) => {
		const b = polygon[(i + 1) % polygon.length];
		if (a.y > y !== b.y > y && x < a.x + ((b.x - a.x) * (y - a.y)) / (b.y - a.y)) odd = !odd;
	});
	return odd;
}

/** Distance of a point from a polygon's edges. */
export function distance(polygon, x, y) {
	const from = polygon.map((a, i) => {
		const b = polygon[(i + 1) % polygon.length];
		const [along, up] = [b.x - a.x, b.y - a.y];
		const square = along * along + up * up;
		const share = square > 0 ? Math.min(1, Math.max(0, ((x - a.x) * along + (y - a.y) * up) / square)) : 0;
		return Math.hypot(x - a.x - share * along, y - a.y - share * up);
	});
	return Math.min(...from);
}

/** The octahedron in the front view and in the side view, as the outlines are: pixels, y down from p1. */
function octahedron(p) {
	return [
		["p3", "p4"],
		["p5", "p6"],
	].map(([right, left]) => [
		{ x: 0, y: 0 },
		{ x: p[`${right}w`], y: p[`${right}r`] },
		{ x: 0, y: p.l },
		{ x: -p[`${left}w`], y: p[`${left}r`] },
	]);
}

/**
 * Of a specimen's parameters, on a grid of one pixel of the profile; both views count by their area.
 *
 * @param outlines polygons of the front and the side view
 * @param radius of a berry, by which the outline is grown before spill is counted; pixels
 */
export function octahedronFit(parameters, outlines, radius) {
	const count = { outline: 0, covered: 0, solid: 0, spilled: 0 };
	octahedron(parameters).forEach((solid, view) => {
		const outline = outlines[view];
		const corners = [...solid, ...outline];
		const [xs, ys] = [corners.map(({ x }) => x), corners.map(({ y }) => y)];
		for (let y = Math.floor(Math.min(...ys)) + 0.5; y < Math.max(...ys); y++) {
			for (let x = Math.floor(Math.min(...xs)) + 0.5; x < Math.max(...xs); x++) {
				const [wanted, there] = [inside(outline, x, y), inside(solid, x, y)];
				count.outline += wanted;
				count.covered += wanted && there;
				count.solid += there;
				count.spilled += there && !wanted && distance(outline, x, y) > radius;
			}
		}
	});
	return { coverage: count.covered / count.outline, spill: count.spilled / count.solid };
}
