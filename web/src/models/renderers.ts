/** Renderers of plants; their scripts load when first needed. */

import type { Plant } from "../plant/plant";
import { swayOf } from "../plant/sway";
import type { RendererFactory } from "../render/model_renderer";
import type { Specimen } from "../specimen/specimen";
import type { PageModel } from "./page_model";

type SceneModule = typeof import("../render/viewer");
type Maker = RendererFactory<Specimen, Plant>;

let loading: Promise<SceneModule> | undefined;
const figures = new Map<PageModel, Promise<Maker>>();

/** Starts loading the scene's script, the largest of the page. Later calls give the same promise, unless it failed. */
export function loadScene(): Promise<SceneModule> {
	if (loading) return loading;
	const scene = import("../render/viewer");
	loading = scene;
	scene.catch(() => {
		loading = undefined;
	});
	return scene;
}

/** Starts loading a model's renderer: its own, or the one that draws parts. */
export function loadRenderer(model: PageModel): Promise<Maker> {
	const before = figures.get(model);
	if (before) return before;
	const figure =
		model.render?.() ??
		import("../render/part_renderer").then(({ partRenderer }) =>
			partRenderer(
				(grown, from) => model.parts(grown, from),
				undefined,
				(grown) => swayOf(grown),
			),
		);
	figures.set(model, figure);
	figure.catch(() => figures.delete(model));
	return figure;
}
