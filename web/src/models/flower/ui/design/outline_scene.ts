/** Scene of a blade's outline with draggable points, and the polynomial that is fitted to it. */

import type { Point } from "../../../../ui/handles/point";
import { halfWidthAt, outlineOf } from "../../design/blade";
import { type Description, described } from "../../design/description";
import { type Margin, marginOf, moved, widthOf } from "../../design/margin";
import { DRAWN, SHAPES, stepAt } from "../../design/shapes";
import { text } from "../../messages.generated";
import { pathOf, type Scene, type SceneHandle } from "./scene";

/** Length of the drawn organ in the scene's units; widths are to scale. */
const LONG = 100;
/** Number of segments of a side's line. */
const SEGMENTS = 60;
/** Margins of the view: beside the organ, as a factor of its half width, and beyond its ends, as a share of `LONG`. */
const SIDE_MARGIN = 1.15;
const END_MARGIN = 0.06;
const LEAST_HALF_VIEW = 12;
/** Steps of the arrow keys, as a share of the organ's length or half width. */
const STEP = { small: 0.01, large: 0.1 } as const;

/** Returns the points of a drawn outline, or the ones that drawing would start from. */
export function pointsOf({ values, margin }: Description): Margin {
	return values.outline === DRAWN && margin
		? margin
		: marginOf((SHAPES[String(values.outline)] ?? SHAPES.elliptic).width);
}

/**
 * Returns the outline of an organ as it grows, in the colour of its tip, with a handle for each of its points. A drawn
 * outline is shown faintly, too: the grown one is a polynomial that only approximates it.
 */
export function outlineScene(description: Description): Scene {
	const { length, width } = description.values;
	const halfWidth = (LONG * Number(width)) / Number(length) / 2;
	const points = pointsOf(description);
	const fit = outlineOf(description);
	const drawnWidthAt = widthOf(points);
	const steps = Array.from({ length: SEGMENTS + 1 }, (_, i) => i / SEGMENTS);
	const outlinePath = (widthAt: (along: number) => number): string => {
		const right: Point[] = steps.map((u) => ({ x: halfWidth * widthAt(u), y: -LONG * u }));
		const left = right.map(({ x, y }) => ({ x: -x, y }));
		return pathOf([...right, ...left.reverse()], true);
	};
	// Drawn points may stay below the greatest width; the fit is normalised to it.
	const greatestWidth = Math.max(...steps.map(drawnWidthAt), 1e-6);
	const grownWidthAt = (u: number): number => halfWidthAt(fit, stepAt(u, fit.even));
	const halfView = Math.max(halfWidth * SIDE_MARGIN, LEAST_HALF_VIEW);
	return {
		box: { left: -halfView, right: halfView, top: -LONG * (1 + END_MARGIN), bottom: LONG * END_MARGIN },
		lines: [
			{ d: outlinePath(grownWidthAt), kind: "organ", fill: String(description.values.tip), chosen: true },
			...(description.values.outline === DRAWN
				? [{ d: outlinePath((u) => drawnWidthAt(u) / greatestWidth), kind: "faint" } as const]
				: []),
			{ d: `M0 0V${-LONG}`, kind: "axis" },
		],
		handles: points.map((_, index) => pointHandle(description, points, index, halfWidth)),
	};
}

/**
 * Returns the handle of one point of an outline. Its `pull` and `nudge` return the organ's description with the point
 * moved, and with the outline changed to a drawn one.
 * @param halfWidth the organ's greatest half width in the scene's units: x of a point whose `out` is 1
 */
function pointHandle(description: Description, points: Margin, index: number, halfWidth: number): SceneHandle {
	const point = points[index];
	const withMargin = (margin: Margin) => described(description, { outline: DRAWN }, margin);
	const last = index === points.length - 1;
	const name =
		index === 0 ? text("width_at_base") : last ? text("width_at_tip") : text("outline_point", { number: index });
	return {
		id: `point-${index}`,
		label: name,
		value: text("outline_value", { out: Math.round(100 * point.out), along: Math.round(100 * point.along) }),
		at: { x: halfWidth * point.out, y: -LONG * point.along },
		pull: ({ x, y }) => withMargin(moved(points, index, { along: -y / LONG, out: x / halfWidth })),
		nudge: (right, up, large) => {
			const step = large ? STEP.large : STEP.small;
			return withMargin(moved(points, index, { along: point.along + up * step, out: point.out + right * step }));
		},
	};
}
