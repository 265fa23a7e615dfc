/**
 * Vertex colours in glTF: `COLOR_0` can only darken a material's base colour. So the base is the brightest of all
 * vertices, channel by channel: no colour is clipped, dark skins have all steps of eight bits, and a viewer without
 * vertex colours still shows a plant of the right colour.
 */
import type { Colour } from "../plant/colour";
import type { Material } from "../plant/material";
import type { PartMesh } from "../plant/part";
import { repeatedColour, shaded } from "../plant/shade";

/** Returns the brightest of vertex colours and of `soFar`, channel by channel; linear light. */
export function brightest(colours: Float32Array, soFar: Colour = [0, 0, 0]): Colour {
	const base: Colour = [...soFar];
	for (let i = 0; i < colours.length; i += 3) {
		for (let channel = 0; channel < 3; channel++) {
			if (colours[i + channel] > base[channel]) base[channel] = colours[i + channel];
		}
	}
	return base;
}

/** Returns the factor on `base` at each vertex: 4 × vertices, red, green, blue, 255. */
export function sharesOf(colours: Float32Array, base: Colour): Uint8Array {
	const scale = base.map((value) => (value > 0 ? 255 / value : 0));
	const bytes = new Uint8Array((colours.length / 3) * 4);
	for (let i = 0, at = 0; i < colours.length; i += 3, at += 4) {
		bytes[at] = Math.round(colours[i] * scale[0]);
		bytes[at + 1] = Math.round(colours[i + 1] * scale[1]);
		bytes[at + 2] = Math.round(colours[i + 2] * scale[2]);
		bytes[at + 3] = 255;
	}
	return bytes;
}

/**
 * Returns the base colour of a mesh without vertex colours: white for a material with a picture, which replaces the
 * colour.
 */
export function plainBase({ colour, textures }: Material): Colour {
	return textures?.colour ? [1, 1, 1] : colour;
}

/**
 * Returns vertex colours in the shade: most programs have no other way to show it. Undefined for a mesh without colours
 * and without computed sky.
 */
export function writtenColours(mesh: PartMesh, material: Material): Float32Array | undefined {
	const { colours, sky, positions } = mesh;
	if (!sky) return colours;
	const under = colours ? undefined : material.textures?.colour && material.colour;
	return shaded(colours ?? repeatedColour(plainBase(material), positions.length / 3), sky, under);
}
