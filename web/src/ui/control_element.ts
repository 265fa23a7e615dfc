import type { PropertyValues } from "lit";
import type { Species } from "../specimen/species";
import type { Desk } from "./desk";
import { DeskElement } from "./desk_element";

/**
 * A control that belongs to one model. When another model comes to the desk it stands still until the page takes it away:
 * what it would draw is not there any more.
 */
export abstract class ControlElement<D extends Desk = Desk> extends DeskElement<D> {
	/** The model that was on the desk when the page last put the control to use. */
	#model: Species | undefined;

	protected override shouldUpdate(changed: PropertyValues): boolean {
		if (!super.shouldUpdate(changed)) return false;
		const { model } = this.desk.state;
		if (changed.size > 0) this.#model = model;
		return model === this.#model;
	}
}
