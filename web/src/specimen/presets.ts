/** Named specimens to start from. */
import { readChoice } from "./read_values";
import type { Table } from "./table";

/** A group of presets in the gallery. */
export interface PresetKind {
	readonly key: string;
	/** In the plural: "Varieties". */
	readonly title: string;
}

/**
 * A named specimen; it holds only values that differ from the defaults of the parameter table. Links hold only values
 * that differ from their preset, so the values of a published preset never change.
 */
export interface Preset {
	/** The name in links and on the command line. */
	readonly name: string;
	/** The key of its kind. */
	readonly kind: string;
	readonly title: string;
	/** The figure in the paper, if any. */
	readonly figure?: string;
	/** The first link version that knows it; version 1 where absent. */
	readonly since?: number;
	/** One line of description. */
	readonly about: string;
	readonly parameters: Readonly<Partial<Record<string, number>>>;
	readonly look: Readonly<Partial<Record<string, number | string>>>;
	/** Values besides parameters, by the fields of a specimen. */
	readonly details?: Readonly<Record<string, unknown>>;
}

/** A model's presets, in the order of the gallery. */
export class Presets {
	readonly #byName: ReadonlyMap<string, Preset>;

	/**
	 * @param kinds in the order of the gallery
	 * @param standard the preset of links without one
	 */
	constructor(
		readonly list: readonly Preset[],
		readonly kinds: readonly PresetKind[],
		readonly standard: string,
	) {
		this.#byName = new Map(list.map((preset) => [preset.name, preset]));
	}

	/** The preset of that name, if any. */
	named(name: string): Preset | undefined {
		return this.#byName.get(name);
	}
}

/** The parameters of a preset's file as numbers; choices become indices of their options. */
export function numbersIn(
	table: Table,
	values: Readonly<Partial<Record<string, number | string>>>,
): Partial<Record<string, number>> {
	const numbers: Partial<Record<string, number>> = {};
	for (const [key, value] of Object.entries(values)) {
		const entry = table.entry(key);
		numbers[key] = entry?.kind === "choice" ? readChoice(value, entry.options) : (value as number);
	}
	return numbers;
}
