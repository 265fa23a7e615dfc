/** Ambient light that remains where part of the sky is hidden. */
import type { Colour } from "./colour";

/**
 * Coefficients of light that bounces between equal surfaces, which brightens and tints the shade: a cubic in
 * visibility, its three coefficients linear in the albedo, [slope, offset] each (Jimenez et al. 2016, "Practical
 * real-time strategies for accurate indirect occlusion", equation 10).
 */
export const BOUNCE = [
	[2.0404, -0.3324],
	[-4.7951, 0.6417],
	[2.7552, 0.6903],
] as const;

/**
 * Returns the share of ambient light that a surface reflects, relative to an open sky.
 * @param visible share of the sky that it sees, 0 … 1
 */
export function bounced(visible: number, albedo: number): number {
	const [[a1, a0], [b1, b0], [c1, c0]] = BOUNCE;
	const [a, b, c] = [a1 * albedo + a0, b1 * albedo + b0, c1 * albedo + c0];
	return Math.max(visible, ((visible * a + b) * visible + c) * visible);
}

/**
 * Returns colours (3 × vertices) in the shade of the sky that each vertex sees (255: all).
 * @param under mean of the picture that the colours multiply
 */
export function shaded(colours: Float32Array, sky: Uint8Array, under: Colour = [1, 1, 1]): Float32Array {
	const dimmed = new Float32Array(colours.length);
	for (let i = 0; i < colours.length; i++) {
		const visible = sky[Math.floor(i / 3)] / 255;
		dimmed[i] = visible < 1 ? colours[i] * Math.min(1, bounced(visible, colours[i] * under[i % 3])) : colours[i];
	}
	return dimmed;
}

/** Returns one colour, repeated for all vertices. */
export function repeatedColour(colour: Colour, vertices: number): Float32Array {
	const colours = new Float32Array(3 * vertices);
	for (let i = 0; i < vertices; i++) colours.set(colour, 3 * i);
	return colours;
}
