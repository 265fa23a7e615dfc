/** Describes a leaf in a few words, for captions, descriptions of pictures and screen readers. */

import type { Leaf } from "./grown";
import { text } from "./messages.generated";
import { packOutline } from "./outline/packed";
import { LEAF, leafFromPreset } from "./schema";
import type { LeafSpecimen } from "./specimen";

/**
 * Describes a leaf: "Oak leaf, 42 cm², 11 cm long, 2.3 m of veins"; while particles move, with their number. A leaf
 * whose outline differs from its preset's is a "Leaf with an outline of its own": a traced leaf may be of any species.
 */
export function leafInWords({ chart, margin, counts }: Leaf, specimen: LeafSpecimen): string {
	const { length, age } = specimen.parameters;
	const name = nameOf(specimen);
	const args = {
		name,
		area: rounded(polygonArea(margin) * (length / 10) ** 2),
		length: rounded((heightOf(margin) * length) / 10),
		veins: rounded((totalLength(chart) * length) / 1000),
	};
	return age < 100 ? text("summary_running", { ...args, particles: counts.particles }) : text("summary", args);
}

/** Returns "Oak leaf" from the preset's title, or "Leaf with an outline of its own" where the outline was edited. */
function nameOf({ preset, outline }: LeafSpecimen): string {
	if (packOutline(outline) !== packOutline(leafFromPreset(preset).outline)) return text("name_own_outline");
	const title = LEAF.presets.named(preset)?.title ?? "";
	return title.toLowerCase().includes("leaf") ? title : text("name_leaf", { species: title });
}

/** Rounds to two significant figures, or to a whole number from 10 on. */
function rounded(value: number): number {
	return value >= 10 ? Math.round(value) : Number(value.toPrecision(2));
}

/** Returns the signed area of a closed polygon, 2 × points, by the shoelace formula. */
export function polygonArea(points: Float32Array): number {
	let double = 0;
	for (let at = 0; at < points.length; at += 2) {
		const next = (at + 2) % points.length;
		double += points[at] * points[next + 1] - points[next] * points[at + 1];
	}
	return double / 2;
}

/** Returns the total length of line segments, 4 numbers each: start x y, end x y. */
function totalLength(ends: Float32Array): number {
	let sum = 0;
	for (let at = 0; at < ends.length; at += 4) sum += Math.hypot(ends[at + 2] - ends[at], ends[at + 3] - ends[at + 1]);
	return sum;
}

/** Returns the difference between the largest and the least y of 2 × points; 0 without points. */
function heightOf(points: Float32Array): number {
	const ys = Array.from({ length: points.length / 2 }, (_, i) => points[2 * i + 1]);
	return points.length > 0 ? Math.max(...ys) - Math.min(...ys) : 0;
}
