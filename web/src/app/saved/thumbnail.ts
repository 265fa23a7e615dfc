/** Makes a small picture of the 3-D view. */

/** Size in pixels; square, so that both tall and wide plants fit. */
export const THUMBNAIL = { width: 240, height: 240 };
/** Factor by which the picture is larger before it is scaled down, for smooth edges. */
const FINER = 2;
const QUALITY = 0.85;

/**
 * Returns the middle of the view, as a JPEG of some ten kilobytes.
 * @param take takes a picture of the given height, in pixels
 * @throws errors of `take`, and an Error if the browser makes no JPEG
 */
export async function thumbnailOf(
	take: (options: { height: number }) => Promise<Blob>,
): Promise<Uint8Array<ArrayBuffer>> {
	const taken = await createImageBitmap(await take({ height: FINER * THUMBNAIL.height }));
	const canvas = Object.assign(document.createElement("canvas"), THUMBNAIL);
	const context = canvas.getContext("2d", { alpha: false });
	if (!context) throw new Error("The browser draws no pictures.");
	context.imageSmoothingQuality = "high";
	const scale = Math.max(canvas.width / taken.width, canvas.height / taken.height);
	const [width, height] = [taken.width * scale, taken.height * scale];
	context.drawImage(taken, (canvas.width - width) / 2, (canvas.height - height) / 2, width, height);
	taken.close();
	const jpeg = await new Promise<Blob | null>((resolve) => canvas.toBlob(resolve, "image/jpeg", QUALITY));
	if (jpeg?.type !== "image/jpeg") throw new Error("The browser makes no JPEGs.");
	return new Uint8Array(await jpeg.arrayBuffer());
}
