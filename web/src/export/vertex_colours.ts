/**
 * Colours of vertices as glTF wants them: `COLOR_0` can only darken what a material's base colour says. So the base is
 * the brightest of all vertices, channel by channel: nothing is cut off, dark skins keep as many steps as eight bits
 * have, and a viewer that knows no vertex colours still shows the colour of the bunch.
 */
import type { Colour } from "./colour";
import { rounded } from "./numbers";

export interface VertexColours {
	/** To multiply with `bytes`; linear. */
	base: Colour;
	/** 4 × vertices: red, green, blue, 255. */
	bytes: Uint8Array;
}

/** @param colours 3 × vertices, linear, 0 … 1 */
export function vertexColours(colours: Float32Array): VertexColours {
	const base: Colour = [0, 0, 0];
	for (let i = 0; i < colours.length; i += 3) {
		for (let channel = 0; channel < 3; channel++) {
			if (colours[i + channel] > base[channel]) base[channel] = colours[i + channel];
		}
	}
	const scale = base.map((value) => (value > 0 ? 255 / value : 0));
	const bytes = new Uint8Array((colours.length / 3) * 4);
	for (let i = 0, at = 0; i < colours.length; i += 3, at += 4) {
		bytes[at] = Math.round(colours[i] * scale[0]);
		bytes[at + 1] = Math.round(colours[i + 1] * scale[1]);
		bytes[at + 2] = Math.round(colours[i + 2] * scale[2]);
		bytes[at + 3] = 255;
	}
	return { base: base.map((value) => rounded(value, 6)) as Colour, bytes };
}

/** The mean of 3 × vertices, at least one. */
export function meanColour(colours: Float32Array): Colour {
	const sum: Colour = [0, 0, 0];
	for (let i = 0; i < colours.length; i++) sum[i % 3] += colours[i];
	return sum.map((value) => value / (colours.length / 3)) as Colour;
}
