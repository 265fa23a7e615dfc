/** Separates a plant from its background by two pictures, over black and over white (Porter & Duff 1984, "matting"). */

/** Computes the cut-out from two opaque pictures, 4 × pixels each; alpha is the coverage of the background, 0 … 255. */
export function cutOut(onBlack: Uint8ClampedArray, onWhite: Uint8ClampedArray): Uint8ClampedArray<ArrayBuffer> {
	const cut = new Uint8ClampedArray(onBlack.length);
	for (let at = 0; at < cut.length; at += 4) {
		const ground =
			(onWhite[at] - onBlack[at] + onWhite[at + 1] - onBlack[at + 1] + onWhite[at + 2] - onBlack[at + 2]) / 3;
		const cover = Math.min(255, Math.max(0, 255 - ground));
		for (let k = 0; k < 3; k++) cut[at + k] = cover > 0 ? (255 * onBlack[at + k]) / cover : 0;
		cut[at + 3] = cover;
	}
	return cut;
}

/**
 * Returns the drawing on a canvas as a PNG with a transparent background. All drawing is finished when the call
 * returns.
 * @param draw draws over black (0), over white (1), or over the usual background; the last call always restores the
 * usual background, even after an error
 */
export function cutOutOf(canvas: HTMLCanvasElement, draw: (ground?: 0 | 1) => void): Promise<Blob> {
	try {
		draw(0);
		// Drawing has made the canvas as large as the picture.
		const { width, height } = canvas;
		const copy = new OffscreenCanvas(width, height);
		const context = copy.getContext("2d", { willReadFrequently: true });
		if (!context) throw new Error(`The browser has no room for ${width} × ${height} pixels; try a smaller picture.`);
		const copied = () => {
			context.drawImage(canvas, 0, 0);
			return context.getImageData(0, 0, width, height).data;
		};
		const onBlack = copied();
		draw(1);
		const onWhite = copied();
		context.putImageData(new ImageData(cutOut(onBlack, onWhite), width, height), 0, 0);
		return copy.convertToBlob({ type: "image/png" });
	} finally {
		draw();
	}
}
