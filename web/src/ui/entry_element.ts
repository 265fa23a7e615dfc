import { type ParameterEntry, valueIn } from "../specimen/table";
import { ControlElement } from "./control_element";
import type { Change } from "./editor_context";

/** Base class of the control of one parameter. A double click on the label, or Delete, restores the preset's value. */
export abstract class EntryElement<E extends ParameterEntry> extends ControlElement {
	static override properties = { ...ControlElement.properties, entry: { attribute: false } };
	declare entry: E;

	/** Returns the values whose change redraws the control: its value or the preset's. */
	protected override shows(): readonly unknown[] {
		return [this.value, this.published];
	}

	/** The document's value. */
	protected get value(): number | string | undefined {
		return valueIn(this.context.state.specimen, this.entry);
	}

	/** The preset's value. */
	protected get published(): number | string | undefined {
		return valueIn(this.context.preset, this.entry);
	}

	/** Returns the change that sets the value. */
	protected change(value: number | string): Change {
		const { key, look } = this.entry;
		return look ? { look: { [key]: value } } : { parameters: { [key]: Number(value) } };
	}

	/** Restores the preset's value. */
	protected reset(): void {
		if (this.published !== undefined) this.context.set(this.change(this.published));
	}
}
