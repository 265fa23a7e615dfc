/** Models' tools and words for the page, each fetched once. */

import type { PageModel } from "../models/page_model";
import type { ModelUi } from "../ui/tool";

/** The page's side of a model that has none. */
export const EMPTY_MODEL_UI: ModelUi = { tools: [] };

export class ModelUis {
	readonly #modelUis = new Map<PageModel, ModelUi>();

	/** The face of a model, if it has come. */
	known(model: PageModel): ModelUi | undefined {
		return this.#modelUis.get(model);
	}

	/** @throws what the fetching of its script throws; a later call fetches it again */
	async of(model: PageModel): Promise<ModelUi> {
		const modelUi = this.#modelUis.get(model) ?? (await model.ui?.()) ?? EMPTY_MODEL_UI;
		this.#modelUis.set(model, modelUi);
		return modelUi;
	}
}
