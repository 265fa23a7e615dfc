/** Loads models' tools and texts for the page, each once. */

import type { PageModel } from "../models/page_model";
import type { ModelUi } from "../ui/tool";

/** The UI of a model without tools. */
export const EMPTY_MODEL_UI: ModelUi = { tools: [] };

export class ModelUis {
	readonly #modelUis = new Map<PageModel, ModelUi>();

	/** Returns the UI of a model; undefined before it is loaded. */
	known(model: PageModel): ModelUi | undefined {
		return this.#modelUis.get(model);
	}

	/** Loads the UI of a model. @throws errors of fetching its script; a later call fetches it again */
	async of(model: PageModel): Promise<ModelUi> {
		const modelUi = this.#modelUis.get(model) ?? (await model.ui?.()) ?? EMPTY_MODEL_UI;
		this.#modelUis.set(model, modelUi);
		return modelUi;
	}
}
