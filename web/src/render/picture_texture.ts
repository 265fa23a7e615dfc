import {
	DataTexture,
	LinearFilter,
	LinearMipmapLinearFilter,
	NoColorSpace,
	RepeatWrapping,
	SRGBColorSpace,
} from "three";
import type { Picture } from "../plant/material";
import { asCardsTakeIt } from "../plant/picture";

/** Seen at a slant, a leaf's veins would blur. */
const ANISOTROPY = 4;

/** A picture as three's texture: the first row is v = 0. */
export function pictureTexture(picture: Picture, isColour: boolean, repeats = false): DataTexture {
	const { width, height, pixels } = asCardsTakeIt(picture);
	const texture = new DataTexture(pixels, width, height);
	texture.colorSpace = isColour ? SRGBColorSpace : NoColorSpace;
	if (repeats) texture.wrapS = texture.wrapT = RepeatWrapping;
	texture.magFilter = LinearFilter;
	texture.minFilter = LinearMipmapLinearFilter;
	texture.generateMipmaps = true;
	texture.anisotropy = ANISOTROPY;
	texture.needsUpdate = true;
	return texture;
}
