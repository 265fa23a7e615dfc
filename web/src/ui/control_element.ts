import type { PropertyValues } from "lit";
import type { ModelSchema } from "../specimen/model_schema";
import type { EditorContext } from "./editor_context";
import { EditorElement } from "./editor_element";

/**
 * Base class of controls that belong to one model. After another model is opened, the control no longer draws, because
 * its entries no longer exist, until the page removes it.
 */
export abstract class ControlElement<D extends EditorContext = EditorContext> extends EditorElement<D> {
	/** Model that was open when the page last set the control's properties. */
	#model: ModelSchema | undefined;

	protected override shouldUpdate(changed: PropertyValues): boolean {
		if (!super.shouldUpdate(changed)) return false;
		const { model } = this.context.state;
		if (changed.size > 0) this.#model = model;
		return model === this.#model;
	}
}
