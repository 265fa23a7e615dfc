import {
	DataTexture,
	LinearFilter,
	LinearMipmapLinearFilter,
	NoColorSpace,
	RepeatWrapping,
	SRGBColorSpace,
} from "three";
import type { Picture } from "../plant/material";
import { rgbaPicture } from "../plant/picture";

/** Anisotropic filtering, because a leaf's veins would blur at a slant. */
const ANISOTROPY = 4;

/**
 * Converts a picture to a three.js texture: the first row is v = 0.
 * @param isColour whether the pixels are sRGB colours, else numbers (normals)
 * @param repeats whether the picture repeats beyond its edges
 */
export function pictureTexture(picture: Picture, isColour: boolean, repeats = false): DataTexture {
	const { width, height, pixels } = rgbaPicture(picture);
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
