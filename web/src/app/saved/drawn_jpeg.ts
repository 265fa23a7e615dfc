/** Draws a stored picture on a canvas: the page's content security policy forbids blob and data addresses. */
import { isSmallJpeg } from "./jpeg_size";

/** Width and height of the canvas, pixels: those of the pictures that thumbnail.ts makes. */
const SIDE = 240;

/** Returns a canvas with the picture; undefined where the bytes are no JPEG, or one that is too large to decode safely. */
export async function drawnJpeg(picture: Uint8Array<ArrayBuffer>): Promise<HTMLCanvasElement | undefined> {
	if (!isSmallJpeg(picture)) return undefined;
	const bitmap = await createImageBitmap(new Blob([picture], { type: "image/jpeg" })).catch(() => undefined);
	if (!bitmap) return undefined;
	const canvas = Object.assign(document.createElement("canvas"), { width: SIDE, height: SIDE });
	canvas.getContext("2d")?.drawImage(bitmap, 0, 0, SIDE, SIDE);
	bitmap.close();
	return canvas;
}
