/** A page with only views, for tests of the scene without the studio (tests/views/views.ts). */
import wasm from "../../build/core/bunch.wasm?url";
import { Core } from "../../web/src/core/core";
import { compileCore } from "../../web/src/core/loader";
import type { BunchPlant } from "../../web/src/models/bunch/bunch_plant";
import { bunchParts } from "../../web/src/models/bunch/parts/bunch_parts";
import { readBunchPlant } from "../../web/src/models/bunch/read_bunch_plant";
import { bunchRenderer } from "../../web/src/models/bunch/render/bunch_renderer";
import { encodeRequest } from "../../web/src/models/bunch/request";
import { BUNCH } from "../../web/src/models/bunch/schema";
import type { BunchSpecimen } from "../../web/src/models/bunch/specimen";
import type { Material } from "../../web/src/plant/material";
import { swayOf } from "../../web/src/plant/sway";
import { blurred, COSINE_SHARPNESS, rigOf, type Theme } from "../../web/src/render/light";
import { partRenderer } from "../../web/src/render/part_renderer";
import { Renderer } from "../../web/src/render/renderer";
import { Viewer, type ViewerOptions } from "../../web/src/render/viewer";
import { decodeQuery } from "../../web/src/specimen/link";

const core = await Core.instantiate(await compileCore(new URL(wasm, document.baseURI)));

/** A bunch as a link has it: `?preset=riesling&age=6`. */
function grow(query: string): { grown: BunchPlant; specimen: BunchSpecimen } {
	const { specimen } = decodeQuery(BUNCH, query);
	return { grown: readBunchPlant(core.grow(encodeRequest(specimen))), specimen };
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
	const viewer = new Viewer<BunchSpecimen, BunchPlant>(canvas(width, height), {
		still: true,
		reducedMotion: true,
		checked: true,
		...options,
	});
	viewer.use(bunchRenderer);
	const { grown, specimen } = grow(query);
	viewer.show(grown, specimen);
	return viewer;
}

/** Pixels of a picture: 4 × width × height. */
async function pixels(picture: Blob): Promise<{ width: number; height: number; data: Uint8ClampedArray }> {
	const image = await createImageBitmap(picture);
	const { width, height } = image;
	const context = new OffscreenCanvas(width, height).getContext("2d") as OffscreenCanvasRenderingContext2D;
	context.drawImage(image, 0, 0);
	return { width, height, data: context.getImageData(0, 0, width, height).data };
}

/**
 * A matt card in front of the camera, and its expected colour from the light's parameters: linear, red, green, blue.
 */
function card(viewer: Viewer<undefined, undefined>, albedo: number, theme: Theme): number[] {
	const mesh = {
		positions: Float32Array.from([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0], (value) => 0.1 * value),
		normals: Float32Array.from([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]),
		uvs: new Float32Array(8),
		indices: Uint32Array.from([0, 1, 2, 0, 2, 3]),
	};
	const material: Material = { name: "Card", colour: [albedo, albedo, albedo], roughness: 1, specular: 0 };
	viewer.use(partRenderer(() => [{ name: "Card", shape: { mesh, material } }]));
	viewer.show(undefined, undefined);
	viewer.resetView("front");
	const { key, rim, surroundings } = rigOf(theme);
	const gathered = surroundings.map((lobe) => {
		const { axis, sharpness, colour } = blurred(lobe, COSINE_SHARPNESS);
		return colour.map((value) => value * Math.exp(sharpness * (axis.z - 1)));
	});
	return [0, 1, 2].map((k) => {
		const lamps = [key, rim].reduce((sum, lamp) => sum + lamp.irradiance[k] * Math.max(0, lamp.direction.z), 0);
		return albedo * (lamps / Math.PI + gathered.reduce((sum, colour) => sum + colour[k], 0));
	});
}

const tools = { grow, canvas, view, card, pixels, Viewer, Renderer, bunchRenderer, partRenderer, bunchParts, swayOf };
export type Views = typeof tools;
Object.assign(window, { views: tools });
