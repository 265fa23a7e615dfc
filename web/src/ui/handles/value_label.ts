/** Label with a dragged handle's value: above all handles, apart from them, and outside the drawing. */
import { css, html, type TemplateResult } from "lit";
import type { Point } from "./point";

/** Size of a field or a label, CSS pixels. */
export interface Extent {
	readonly width: number;
	readonly height: number;
}

/** Distance from a handle's middle to its label, outside the focus ring. */
const GAP = 15;
/** Radius of a handle that labels must not cover. */
const DOT = 9;
/** Preference for labels above a handle, because fingers are below it. */
const UPWARDS = 0.5;
const AROUND: readonly Point[] = Array.from({ length: 8 }, (_, i) => ({
	x: Math.round(Math.cos((i * Math.PI) / 4)),
	y: Math.round(Math.sin((i * Math.PI) / 4)),
}));

/** Returns the estimated size of a label, slightly too large. */
export function labelExtent(text: string): Extent {
	return { width: 7.1 * text.length + 10, height: 20 };
}

/**
 * Returns the upper left corner of a label, in CSS pixels of the field: next to its handle, away from the field's
 * middle, covering as few handles as possible, and inside the field.
 * @param others positions of the other handles
 */
export function labelPlace(at: Point, label: Extent, field: Extent, others: readonly Point[]): Point {
	const fromMiddle = { x: at.x - field.width / 2, y: at.y - field.height / 2 };
	const distance = Math.hypot(fromMiddle.x, fromMiddle.y) || 1;
	const outward = { x: fromMiddle.x / distance, y: fromMiddle.y / distance - UPWARDS };
	let best: { cost: number; place: Point } | undefined;
	for (const { x, y } of AROUND) {
		const place = {
			x: clampTo(at.x + x * (GAP + label.width / 2) - label.width / 2, field.width - label.width),
			y: clampTo(at.y + y * (GAP + label.height / 2) - label.height / 2, field.height - label.height),
		};
		const covers = (dot: Point) => isCovered(place, label, dot);
		const inward = -(x * outward.x + y * outward.y) / Math.hypot(x, y);
		const cost = others.filter(covers).length + (covers(at) ? 4 : 0) + 0.4 * inward;
		if (!best || cost < best.cost) best = { cost, place };
	}
	return best?.place ?? at;
}

/** Limits a value to 0 … `limit`. */
function clampTo(value: number, limit: number): number {
	return Math.max(0, Math.min(value, limit));
}

/** Returns whether a label covers the middle of a handle. */
function isCovered(place: Point, { width, height }: Extent, dot: Point): boolean {
	const x = Math.max(place.x, Math.min(dot.x, place.x + width));
	const y = Math.max(place.y, Math.min(dot.y, place.y + height));
	return Math.hypot(dot.x - x, dot.y - y) < DOT;
}

/** Draws a label for sighted users; screen readers read the handle's own name. */
export function drawValue(text: string, at: Point, field: Extent, others: readonly Point[]): TemplateResult {
	const { x, y } = labelPlace(at, labelExtent(text), field, others);
	return html`<span class="value" aria-hidden="true" .style=${`transform: translate(${x}px, ${y}px)`}>${text}</span>`;
}

export const valueStyle = css`
	.value {
		position: absolute;
		z-index: 1;
		top: 0;
		left: 0;
		padding: 3px 4px;
		border-radius: 3px;
		background: color-mix(in srgb, var(--ground) 92%, transparent);
		color: var(--grip);
		line-height: 14px;
		white-space: nowrap;
		pointer-events: none;
	}
`;
