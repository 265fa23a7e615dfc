import {
	DataTexture,
	LinearFilter,
	LinearMipmapLinearFilter,
	NoColorSpace,
	RepeatWrapping,
	SRGBColorSpace,
} from "three";
import type { Picture } from "../plant/material";

/** Seen at a slant, a leaf's veins would blur. */
const ANISOTROPY = 4;

/** A picture as three's texture: the first row is v = 0. */
export function pictureTexture({ width, height, pixels }: Picture, isColour: boolean, repeats = false): DataTexture {
	// Cards make smaller copies of four channels only, where they are sRGB.
	const data = new Uint8Array(4 * width * height);
	for (let from = 0, to = 0; to < data.length; from += 3, to += 4) {
		data[to] = pixels[from];
		data[to + 1] = pixels[from + 1];
		data[to + 2] = pixels[from + 2];
		data[to + 3] = 255;
	}
	const texture = new DataTexture(data, width, height);
	texture.colorSpace = isColour ? SRGBColorSpace : NoColorSpace;
	if (repeats) texture.wrapS = texture.wrapT = RepeatWrapping;
	texture.magFilter = LinearFilter;
	texture.minFilter = LinearMipmapLinearFilter;
	texture.generateMipmaps = true;
	texture.anisotropy = ANISOTROPY;
	texture.needsUpdate = true;
	return texture;
}
