import { MessageError } from "../../locale/message_error";

/** Pixels of a picture, as from a canvas. */
export interface PixelImage {
	width: number;
	height: number;
	/** 4 × pixels: red, green, blue, alpha, rows from the top. */
	data: Uint8ClampedArray;
}

/** One byte per pixel: 1 inside. */
export interface Mask {
	width: number;
	height: number;
	inside: Uint8Array;
}

export interface Pixel {
	x: number;
	y: number;
}

/** Error: nothing can be traced from the picture; the message explains to the user how to fix this. */
export class TraceError extends MessageError {
	override name = "TraceError";
}
