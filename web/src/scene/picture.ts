import type { FigureMaker } from "./figure";
import type { Theme } from "./light";
import type { ViewName } from "./turntable";
import { Viewer } from "./viewer";

export interface PictureOptions {
	/** Pixels. */
	width: number;
	height: number;
	theme?: Theme;
	view?: ViewName;
}

/**
 * A picture of a plant, whole and from a fixed direction, as a PNG: the same plant gives the same picture.
 * @throws NoWebGL2Error where the browser has no WebGL 2
 */
export async function renderPicture<S, G>(
	make: FigureMaker<S, G>,
	grown: G,
	specimen: S,
	{ width, height, theme, view }: PictureOptions,
): Promise<Blob> {
	const canvas = Object.assign(document.createElement("canvas"), { width, height });
	const viewer = new Viewer<S, G>(canvas, { still: true, reducedMotion: true, theme });
	try {
		viewer.use(make);
		viewer.show(grown, specimen);
		viewer.resetView(view);
		return await viewer.snapshot(width, height);
	} finally {
		viewer.dispose();
	}
}
