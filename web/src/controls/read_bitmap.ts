/** Pictures that a person brings: what they may be, and how they are read. */

/** For a file input's `accept`. */
export const PICTURES = "image/png,image/jpeg,image/webp";

/** Where the system does not know the type. */
const NAMES = /\.(png|jpe?g|webp)$/i;

export const isPicture = ({ name, type }: Pick<File, "name" | "type">): boolean =>
	type.startsWith("image/") || NAMES.test(name);

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
