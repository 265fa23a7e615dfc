/** A file → pixels, in a page. */
import { type Picture, TraceError } from "./picture";

/** The longer side that is looked at, in pixels: more shows nothing that 48 points could hold. */
const SIDE = 640;

/** @throws TraceError where the file is no picture that this browser reads */
export async function readPicture(file: Blob): Promise<Picture> {
	const bitmap = await createImageBitmap(file).catch(() => {
		throw new TraceError("The file is no picture that this browser reads. Use a JPEG, PNG or WebP.");
	});
	const scale = Math.min(1, SIDE / Math.max(bitmap.width, bitmap.height));
	const [width, height] = [bitmap.width, bitmap.height].map((side) => Math.max(1, Math.round(side * scale)));
	const canvas = document.createElement("canvas");
	canvas.width = width;
	canvas.height = height;
	const pen = canvas.getContext("2d", { willReadFrequently: true });
	if (!pen) throw new TraceError("This browser gives no pixels of a picture.");
	pen.drawImage(bitmap, 0, 0, width, height);
	bitmap.close();
	return { width, height, data: pen.getImageData(0, 0, width, height).data };
}
