/** Traces the margin of a petal, sepal or leaf in a picture. Pure; throws TraceError with a message for users. */

import { contourOf, smoothed } from "../../../import/tracing/contour";
import type { PixelImage } from "../../../import/tracing/picture";
import { silhouetteOf } from "../../../import/tracing/silhouette";
import { withoutStalk } from "../../../import/tracing/stalk";
import { upright } from "../../../import/tracing/upright";
import type { Point } from "../../../ui/handles/point";
import { KNOTS, type Margin } from "./margin";

export interface Traced {
	readonly margin: Margin;
	/** Greatest width divided by the length. */
	readonly wide: number;
}

/** Height of the band in which a width is measured, as a share of the length. */
const BAND = 0.01;

/**
 * Returns the half widths of an organ in a picture, as means of both sides, since an organ's polynomial is symmetric.
 * @param noun the organ's name in error messages: "petal"
 * @throws TraceError
 */
export function tracedMargin(picture: PixelImage, noun: string): Traced {
	const { blade, base } = withoutStalk(silhouetteOf(picture, noun));
	const steps = contourOf(blade);
	const { margin } = upright(smoothed(steps, Math.max(1, 0.002 * steps.length)), base);
	const positions = Array.from({ length: KNOTS }, (_, i) => i / (KNOTS - 1));
	const greatest = Math.max(...Array.from({ length: 99 }, (_, i) => halfWidth(margin, (i + 1) / 100)), 1e-6);
	const points = positions.map((along) => ({
		along,
		out: Math.round(1000 * Math.min(1, halfWidth(margin, along) / greatest)) / 1000,
	}));
	return { margin: points, wide: 2 * greatest };
}

/**
 * Returns half the width of a traced margin at a share of its length: half the distance between the outermost points of
 * a band there.
 */
function halfWidth(margin: readonly Point[], along: number): number {
	const band = margin.filter(({ y }) => Math.abs(y - along) <= BAND).map(({ x }) => x);
	return band.length === 0 ? 0 : (Math.max(...band) - Math.min(...band)) / 2;
}
