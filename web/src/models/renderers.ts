/** What draws plants: scripts that come when they are first asked for. */

import type { Plant } from "../plant/plant";
import { swayOf } from "../plant/sway";
import type { FigureMaker } from "../render/figure";
import type { Specimen } from "../specimen/specimen";
import type { PageModel } from "./page_model";

type SceneModule = typeof import("../render/viewer");
type Maker = FigureMaker<Specimen, Plant>;

let loading: Promise<SceneModule> | undefined;
const figures = new Map<PageModel, Promise<Maker>>();

/** Starts loading the scene's script, the largest of the page; asked for again, it is the same one, unless it failed. */
export function loadScene(): Promise<SceneModule> {
	if (loading) return loading;
	const scene = import("../render/viewer");
	loading = scene;
	scene.catch(() => {
		loading = undefined;
	});
	return scene;
}

/** Starts loading what draws a model's plants: its own figure, or the one that draws any parts. */
export function loadFigure(model: PageModel): Promise<Maker> {
	const before = figures.get(model);
	if (before) return before;
	const figure =
		model.render?.() ??
		import("../render/part_figure").then(({ partFigure }) =>
			partFigure(
				(grown, from) => model.parts(grown, from),
				undefined,
				(grown) => swayOf(grown),
			),
		);
	figures.set(model, figure);
	figure.catch(() => figures.delete(model));
	return figure;
}
