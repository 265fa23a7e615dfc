/** Named specimens to start from. */
import { readChoice } from "./read_values";
import type { Table } from "./table";

/** A sort of preset, as the gallery groups them. */
export interface PresetKind {
	readonly key: string;
	/** In the plural: "Varieties". */
	readonly title: string;
}

/**
 * A named specimen; it holds only what differs from the defaults of the parameter table. Links hold only what differs
 * from their preset, so what a published preset says never changes.
 */
export interface Preset {
	/** As in links and on the command line. */
	readonly name: string;
	/** The key of its kind. */
	readonly kind: string;
	readonly title: string;
	/** The paper's figure, where it has one. */
	readonly figure?: string;
	/** The link version that first knew it; the first where absent. */
	readonly since?: number;
	/** One line about it. */
	readonly about: string;
	readonly parameters: Readonly<Partial<Record<string, number>>>;
	readonly look: Readonly<Partial<Record<string, number | string>>>;
	/** What it has besides parameters, by the fields of a specimen. */
	readonly details?: Readonly<Record<string, unknown>>;
}

/** A model's presets, in the order of the gallery. */
export class Presets {
	readonly #byName: ReadonlyMap<string, Preset>;

	/**
	 * @param kinds in the order of the gallery
	 * @param standard the preset that a link means which names none
	 */
	constructor(
		readonly list: readonly Preset[],
		readonly kinds: readonly PresetKind[],
		readonly standard: string,
	) {
		this.#byName = new Map(list.map((preset) => [preset.name, preset]));
	}

	/** The preset of that name, if there is one. */
	named(name: string): Preset | undefined {
		return this.#byName.get(name);
	}
}

/** A preset's parameters as its file holds them, choices by the names of their options, as numbers. */
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
