/**
 * Numbers of a plant that are no parameter of its table, such as the height of its growth volumes: the panel shows them
 * among the basics like parameters, and the command palette finds them.
 */
import { nothing } from "lit";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import { type NumberEntry, nearestWithin, type ParameterEntry } from "../specimen/table";
import type { Change } from "./editor_context";
import { NumberControl } from "./number";

export interface Quantity<S extends Specimen = Specimen, G extends Plant = Plant> extends NumberEntry {
	/** Returns the number of a specimen and its plant; undefined if it has none. */
	read(specimen: S, grown: G | undefined): number | undefined;
	/** Returns the change that sets the number. */
	change(specimen: S, value: number, grown: G | undefined): Change;
}

/** Members of a parameter that mean nothing for a quantity. */
export const NO_PARAMETER = { link: "", symbol: "", group: "", since: 0, default: 0 } as const;

export const isQuantity = (entry: ParameterEntry): entry is Quantity => "read" in entry;

/** Control of a quantity. */
export class QuantityControl extends NumberControl<Quantity> {
	/** The specimen before the drag: every change of a drag starts from it, so that rounding does not add up. */
	#before: Specimen | undefined;

	protected override draw(): unknown {
		return this.value === undefined ? nothing : super.draw();
	}

	protected override get value(): number | undefined {
		const { specimen, grown } = this.context.state;
		return this.entry.read(specimen, grown);
	}

	/** The preset's number; undefined if it depends on the plant. */
	protected override get published(): number | undefined {
		return this.entry.read(this.context.preset, undefined);
	}

	protected override change(value: number): Change {
		const { specimen, grown, held } = this.context.state;
		if (!held || !this.#before) this.#before = specimen;
		return this.entry.change(this.#before, nearestWithin(this.entry, value), grown);
	}
}

customElements.define("panicle-quantity", QuantityControl);
