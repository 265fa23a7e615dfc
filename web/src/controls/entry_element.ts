import { type Entry, valueIn } from "../specimen/table";
import { ControlElement } from "./control_element";
import type { Change, Desk } from "./desk";

/** The control of one parameter. A double click on its name, or Delete, brings the preset's value back. */
export abstract class EntryElement<E extends Entry> extends ControlElement {
	static override properties = { ...ControlElement.properties, entry: { attribute: false } };
	declare entry: E;

	#drawn: readonly [value: number | string, published: number | string] | undefined;

	/** Draws it, knowing that what `value` and `published` say now is what is shown. */
	protected abstract drawEntry(desk: Desk): unknown;

	protected override draw(desk: Desk): unknown {
		this.#drawn = [this.value, this.published];
		return this.drawEntry(desk);
	}

	protected override concerns(): boolean {
		return this.value !== this.#drawn?.[0] || this.published !== this.#drawn[1];
	}

	protected get value(): number | string {
		return valueIn(this.desk.state.specimen, this.entry);
	}

	/** The preset's value. */
	protected get published(): number | string {
		return valueIn(this.desk.preset, this.entry);
	}

	protected change(value: number | string): Change {
		const { key, look } = this.entry;
		return look ? { look: { [key]: value } } : { parameters: { [key]: Number(value) } };
	}

	protected reset(): void {
		this.desk.set(this.change(this.published));
	}
}
