/** Reads the pixels of a picture file, in a page. */
import { readBitmap } from "../../ui/read_bitmap";
import { text } from "../messages.generated";
import { type PixelImage, TraceError } from "./picture";

/** Longer side of the analysed picture, in pixels; finer details exceed the precision of 48 points. */
const SIDE = 640;

/**
 * Decodes a picture, reduced to at most SIDE pixels along a side.
 * @throws PictureError if the browser cannot read the file
 * @throws TraceError if the browser returns no pixels
 */
export async function readPicture(file: Blob): Promise<PixelImage> {
	const bitmap = await readBitmap(file, SIDE);
	const { width, height } = bitmap;
	const canvas = document.createElement("canvas");
	canvas.width = width;
	canvas.height = height;
	const pen = canvas.getContext("2d", { willReadFrequently: true });
	if (!pen) throw new TraceError(text.message("picture_unreadable"));
	pen.drawImage(bitmap, 0, 0);
	bitmap.close();
	return { width, height, data: pen.getImageData(0, 0, width, height).data };
}
