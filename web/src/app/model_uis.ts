/** Models' tools and words for the page, each fetched once. */

import type { PageModel } from "../models/page_model";
import type { ModelUi } from "../ui/tool";

/** The page's side of a model that has none. */
export const BARE: ModelUi = { tools: [] };

export class Faces {
	readonly #faces = new Map<PageModel, ModelUi>();

	/** The face of a model, if it has come. */
	known(model: PageModel): ModelUi | undefined {
		return this.#faces.get(model);
	}

	/** @throws what the fetching of its script throws; a later call fetches it again */
	async of(model: PageModel): Promise<ModelUi> {
		const face = this.#faces.get(model) ?? (await model.ui?.()) ?? BARE;
		this.#faces.set(model, face);
		return face;
	}
}
