/** A file → pixels, in a page. */
import { readBitmap } from "../../ui/read_bitmap";
import { type PixelImage, TraceError } from "./picture";

/** The longer side that is looked at, in pixels: more shows nothing that 48 points could hold. */
const SIDE = 640;

/** @throws PictureError where the file is no picture that this browser reads, TraceError where it gives no pixels of one */
export async function readPicture(file: Blob): Promise<PixelImage> {
	const bitmap = await readBitmap(file, SIDE);
	const { width, height } = bitmap;
	const canvas = document.createElement("canvas");
	canvas.width = width;
	canvas.height = height;
	const pen = canvas.getContext("2d", { willReadFrequently: true });
	if (!pen) throw new TraceError("This browser gives no pixels of a picture.");
	pen.drawImage(bitmap, 0, 0);
	bitmap.close();
	return { width, height, data: pen.getImageData(0, 0, width, height).data };
}
