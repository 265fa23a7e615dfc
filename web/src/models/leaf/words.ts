/** Describes a leaf in a few words, for captions, descriptions of pictures and screen readers. */

import type { Leaf } from "./grown";
import { packOutline } from "./outline/packed";
import { LEAF, leafFromPreset } from "./schema";
import type { LeafSpecimen } from "./specimen";

/**
 * "Oak leaf, 42 cm², 11 cm long, 2.3 m of veins"; while particles move, with their number. A leaf whose outline
 * differs from its preset's is a "Leaf of an outline of its own": a traced leaf may be of any species.
 */
export function leafInWords({ chart, margin, counts }: Leaf, specimen: LeafSpecimen): string {
	const { length, age } = specimen.parameters;
	const name = nameOf(specimen);
	const area = `${rounded(polygonArea(margin) * (length / 10) ** 2)} cm²`;
	const veins = `${rounded((lengthOf(chart) * length) / 1000)} m of veins`;
	const running = age < 100 ? `${counts.particles} particles, ` : "";
	return `${name}, ${running}${area}, ${rounded((heightOf(margin) * length) / 10)} cm long, ${veins}`;
}

function nameOf({ preset, outline }: LeafSpecimen): string {
	if (packOutline(outline) !== packOutline(leafFromPreset(preset).outline)) return "Leaf of an outline of its own";
	const title = LEAF.presets.named(preset)?.title ?? "";
	return title.toLowerCase().includes("leaf") ? title : `${title} leaf`;
}

/** Two significant figures, or all digits before the decimal point. */
function rounded(value: number): string {
	return value >= 10 ? String(Math.round(value)) : String(Number(value.toPrecision(2)));
}

/** Signed area of a closed polygon, 2 × points. */
export function polygonArea(points: Float32Array): number {
	let double = 0;
	for (let at = 0; at < points.length; at += 2) {
		const next = (at + 2) % points.length;
		double += points[at] * points[next + 1] - points[next] * points[at + 1];
	}
	return double / 2;
}

/** Total length, 4 × pieces. */
function lengthOf(ends: Float32Array): number {
	let sum = 0;
	for (let at = 0; at < ends.length; at += 4) sum += Math.hypot(ends[at + 2] - ends[at], ends[at + 3] - ends[at + 1]);
	return sum;
}

function heightOf(points: Float32Array): number {
	const ys = Array.from({ length: points.length / 2 }, (_, i) => points[2 * i + 1]);
	return points.length > 0 ? Math.max(...ys) - Math.min(...ys) : 0;
}
