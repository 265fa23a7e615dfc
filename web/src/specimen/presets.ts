/** Named specimens to start from. */
import { readChoice } from "./read_values";
import type { Table } from "./table";

/** The families of plants that people choose from, whichever model grows them, in the order in which pages show them. */
export const FAMILIES = ["grapes", "trees", "flowers", "leaves", "roots", "gardens", "grammars", "topiary"] as const;
export type Family = (typeof FAMILIES)[number];

/** A group of presets in the gallery. */
export interface PresetKind {
	readonly key: string;
	/** In the plural: "Varieties". */
	readonly title: string;
	readonly family: Family;
	/** Whether the presets reproduce figures or tables of a publication. */
	readonly fromPaper?: boolean;
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
	/** The publication of its text, and the differences from it. */
	readonly source?: string;
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

	/** Returns the preset of that name; undefined if there is none. */
	named(name: string): Preset | undefined {
		return this.#byName.get(name);
	}
}

/** Returns the parameters of a preset's file as numbers; choices become indices of their options. */
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
