/** A page of nothing but views: what is asked of the scene itself runs here, without the studio (tests/views/views.ts). */
import wasm from "../../build/core/bunch.wasm?url";
import { Core } from "../../web/src/core/core";
import { compileCore } from "../../web/src/core/loader";
import { bunchFigure } from "../../web/src/models/bunch/figure/bunch_figure";
import type { Grown } from "../../web/src/models/bunch/grown";
import { readGrown } from "../../web/src/models/bunch/read_grown";
import { encodeRequest } from "../../web/src/models/bunch/request";
import { BUNCH } from "../../web/src/models/bunch/species";
import type { BunchSpecimen } from "../../web/src/models/bunch/specimen";
import { Viewer, type ViewerOptions } from "../../web/src/scene/viewer";
import { decodeQuery } from "../../web/src/specimen/link";

const core = await Core.instantiate(await compileCore(new URL(wasm, document.baseURI)));

/** A bunch as a link has it: `?preset=riesling&age=6`. */
function grow(query: string): { grown: Grown; specimen: BunchSpecimen } {
	const { specimen } = decodeQuery(BUNCH, query);
	return { grown: readGrown(core.grow(encodeRequest(specimen))), specimen };
}

/** A canvas on the page, so many CSS pixels large. */
function canvas(width: number, height: number): HTMLCanvasElement {
	const made = Object.assign(document.createElement("canvas"), { width, height });
	made.style.cssText = `display: block; width: ${width}px; height: ${height}px`;
	document.body.append(made);
	return made;
}

/** A view of a bunch that keeps still. */
function view(query: string, [width, height]: readonly [number, number], options: ViewerOptions = {}) {
	const viewer = new Viewer<BunchSpecimen, Grown>(canvas(width, height), {
		still: true,
		reducedMotion: true,
		checked: true,
		...options,
	});
	viewer.use(bunchFigure);
	const { grown, specimen } = grow(query);
	viewer.show(grown, specimen);
	return viewer;
}

/** What a picture shows, pixel by pixel: 4 × width × height. */
async function pixels(picture: Blob): Promise<{ width: number; height: number; data: Uint8ClampedArray }> {
	const image = await createImageBitmap(picture);
	const { width, height } = image;
	const context = new OffscreenCanvas(width, height).getContext("2d") as OffscreenCanvasRenderingContext2D;
	context.drawImage(image, 0, 0);
	return { width, height, data: context.getImageData(0, 0, width, height).data };
}

const tools = { grow, canvas, view, pixels, Viewer, bunchFigure };
export type Views = typeof tools;
Object.assign(window, { views: tools });
