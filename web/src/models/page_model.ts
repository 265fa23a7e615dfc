/** A model as pages use it: drawing and editing come from modules of their own, loaded when needed. Types only. */
import type { Plant } from "../plant/plant";
import type { RendererFactory } from "../render/model_renderer";
import type { Specimen } from "../specimen/specimen";
import type { HandlesOf } from "../ui/handles/plant_handle";
import type { ModelUi } from "../ui/tool";
import type { Model } from "./model";

export interface PageModel<S extends Specimen = Specimen, G extends Plant = Plant> extends Model<S, G> {
	/** Loads the model's own renderer, with three.js in its module; absent where a renderer of `parts` is enough. */
	render?(): Promise<RendererFactory<S, G>>;
	/** Whether its plants can be shown outdoors: its renderer has a light for that. */
	outdoors?: true;
	/** Loads the handles on the plant, for pages that show it alone. */
	handles?(): Promise<HandlesOf<S>>;
	/** Loads the model's tools, flat views, panel sections, read-out and bars, with Lit in their module. */
	ui?(): Promise<ModelUi<S, G>>;
}
