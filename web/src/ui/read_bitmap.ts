/** Pictures that a person brings, read. */

/** The message is a sentence for the person. */
export class PictureError extends Error {
	override name = "PictureError";
}

/**
 * A picture no larger than it is of use.
 * @param longest of its sides, in pixels
 * @throws PictureError where the file is no picture that this browser reads
 */
export async function readBitmap(file: Blob, longest: number): Promise<ImageBitmap> {
	const bitmap = await createImageBitmap(file).catch(() => {
		throw new PictureError("The file is no picture that this browser reads. Use a JPEG, PNG or WebP.");
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
