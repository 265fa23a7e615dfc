import type { Grown } from "../models/bunch/grown";
import type { Look } from "../specimen/specimen";
import { BunchView } from "./bunch_view";
import type { Theme } from "./light";
import type { ViewName } from "./turntable";

export interface PictureOptions {
	/** Pixels. */
	width: number;
	height: number;
	theme?: Theme;
	view?: ViewName;
}

/**
 * A picture of a bunch, whole and from a fixed direction, as a PNG: the same bunch gives the same picture.
 * @throws NoWebGL2Error where the browser has no WebGL 2
 */
export async function renderPicture(grown: Grown, look: Look, options: PictureOptions): Promise<Blob> {
	const canvas = document.createElement("canvas");
	canvas.width = options.width;
	canvas.height = options.height;
	const view = new BunchView(canvas, { still: true, reducedMotion: true, theme: options.theme });
	try {
		view.show(grown, look);
		view.resetView(options.view);
		return await view.snapshot(options.width, options.height);
	} finally {
		view.dispose();
	}
}
