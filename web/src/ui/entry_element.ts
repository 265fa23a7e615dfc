import { type ParameterEntry, valueIn } from "../specimen/table";
import { ControlElement } from "./control_element";
import type { Change } from "./editor_context";

/** Base class of the control of one parameter. A double click on the label, or Delete, restores the preset's value. */
export abstract class EntryElement<E extends ParameterEntry> extends ControlElement {
	static override properties = { ...ControlElement.properties, entry: { attribute: false } };
	declare entry: E;

	protected override shows(): readonly unknown[] {
		return [this.value, this.published];
	}

	protected get value(): number | string {
		return valueIn(this.context.state.specimen, this.entry);
	}

	/** The preset's value. */
	protected get published(): number | string {
		return valueIn(this.context.preset, this.entry);
	}

	protected change(value: number | string): Change {
		const { key, look } = this.entry;
		return look ? { look: { [key]: value } } : { parameters: { [key]: Number(value) } };
	}

	protected reset(): void {
		this.context.set(this.change(this.published));
	}
}
