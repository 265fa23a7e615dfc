/** The size of a picture or a canvas, in pixels. */
export interface Size {
	width: number;
	height: number;
}
