/** Reads pictures from the user. */

import { MessageError } from "../locale/message_error";
import { text } from "./messages.generated";

/** Error with a message for the user. */
export class PictureError extends MessageError {
	override name = "PictureError";
}

/**
 * Reads a picture, reduced to a useful size.
 * @param longest largest side, in pixels
 * @throws PictureError if the browser cannot read the file as a picture
 */
export async function readBitmap(file: Blob, longest: number): Promise<ImageBitmap> {
	const bitmap = await createImageBitmap(file).catch(() => {
		throw new PictureError(text.message("picture_unreadable"));
	});
	const scale = longest / Math.max(bitmap.width, bitmap.height);
	if (scale >= 1) return bitmap;
	const [resizeWidth, resizeHeight] = [bitmap.width, bitmap.height].map((side) =>
		Math.max(1, Math.round(side * scale)),
	);
	const smaller = await createImageBitmap(bitmap, { resizeWidth, resizeHeight, resizeQuality: "high" });
	bitmap.close();
	return smaller;
}
