import {
	DataTexture,
	LinearFilter,
	LinearMipmapLinearFilter,
	RepeatWrapping,
	SRGBColorSpace,
	type Texture,
} from "three";
import type { Picture } from "../plant/material";

/** How many samples a picture seen at a slant has. */
const SLANTED = 4;

/** A picture of colours as three's texture: its first row at v = 0, as glTF has it. */
export function pictureTexture({ width, height, pixels }: Picture): Texture {
	const data = new Uint8Array(4 * width * height).fill(255);
	for (let from = 0, to = 0; from < pixels.length; from += 3, to += 4) {
		data[to] = pixels[from];
		data[to + 1] = pixels[from + 1];
		data[to + 2] = pixels[from + 2];
	}
	const texture = new DataTexture(data, width, height);
	texture.colorSpace = SRGBColorSpace;
	texture.wrapS = RepeatWrapping;
	texture.wrapT = RepeatWrapping;
	texture.magFilter = LinearFilter;
	texture.minFilter = LinearMipmapLinearFilter;
	texture.generateMipmaps = true;
	texture.anisotropy = SLANTED;
	texture.needsUpdate = true;
	return texture;
}
