/** Scene of a blade's outline with draggable points, and the polynomial that is fitted to it. */
import type { Point } from "../../../../ui/handles/point";
import { halfWidthAt, outlineOf } from "../../design/blade";
import { type Description, described } from "../../design/description";
import { type Margin, marginOf, moved, widthOf } from "../../design/margin";
import { DRAWN, SHAPES, stepAt } from "../../design/shapes";
import { pathOf, type Scene, type SceneHandle } from "./scene";

/** Length of the drawing; widths are to scale. */
const LONG = 100;
const FINE = 60;

/** Returns the points of a drawn outline, or the ones that drawing would start from. */
export function pointsOf({ values, margin }: Description): Margin {
	return values.outline === DRAWN && margin
		? margin
		: marginOf((SHAPES[String(values.outline)] ?? SHAPES.elliptic).width);
}

export function outlineScene(description: Description): Scene {
	const { length, width } = description.values;
	const wide = (LONG * Number(width)) / Number(length) / 2;
	const points = pointsOf(description);
	const fit = outlineOf(description);
	const drawn = widthOf(points);
	const steps = Array.from({ length: FINE + 1 }, (_, i) => i / FINE);
	const side = (of: (along: number) => number): Point[] => steps.map((u) => ({ x: wide * of(u), y: -LONG * u }));
	const both = (line: readonly Point[]) => pathOf([...line, ...line.map(({ x, y }) => ({ x: -x, y })).reverse()], true);
	// Drawn points may stay below the greatest width; the fit is normalised to it.
	const most = Math.max(...steps.map(drawn), 1e-6);
	const along = (u: number): number => halfWidthAt(fit, stepAt(u, fit.even));
	const across = Math.max(wide * 1.15, 12);
	return {
		box: { left: -across, right: across, top: -LONG * 1.06, bottom: LONG * 0.06 },
		lines: [
			{ d: both(side(along)), kind: "organ", fill: String(description.values.tip), chosen: true },
			...(description.values.outline === DRAWN
				? [{ d: both(side((u) => drawn(u) / most)), kind: "faint" } as const]
				: []),
			{ d: `M0 0V${-LONG}`, kind: "axis" },
		],
		handles: points.map((_, index) => pointHandle(description, points, index, wide)),
	};
}

function pointHandle(description: Description, points: Margin, index: number, wide: number): SceneHandle {
	const point = points[index];
	const put = (margin: Margin) => described(description, { outline: DRAWN }, margin);
	const last = index === points.length - 1;
	const name = index === 0 ? "Width at the foot" : last ? "Width at the tip" : `Point ${index} of the outline`;
	return {
		id: `point-${index}`,
		label: name,
		value: `${Math.round(100 * point.out)} % of the width at ${Math.round(100 * point.along)} % of the length`,
		at: { x: wide * point.out, y: -LONG * point.along },
		pull: ({ x, y }) => put(moved(points, index, { along: -y / LONG, out: x / wide })),
		nudge: (right, up, large) => {
			const by = large ? 0.1 : 0.01;
			return put(moved(points, index, { along: point.along + up * by, out: point.out + right * by }));
		},
	};
}
