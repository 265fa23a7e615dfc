/** Parameter tables (wasm-core/parameters/<model>.json), typed for look-up, and the rounding of values to them. */
import type { MeasureGroup, MeasureInfo } from "./measures";
import type { Specimen } from "./specimen";

interface CommonEntry {
	readonly key: string;
	/** Key in the link, frozen. Parameters that share one are its comma-separated values, by `slot`. */
	readonly link: string;
	readonly slot?: number;
	readonly label: string;
	/** The symbol in the paper, or empty. */
	readonly symbol: string;
	/** The key of its group. */
	readonly group: string;
	/** Empty for choices and colours. */
	readonly unit: string;
	/** One plain sentence. */
	readonly help: string;
	/** The first link version that knows it. */
	readonly since: number;
	/** Whether it only colours the result. */
	readonly look?: boolean;
	/** Options of choices that must be chosen for the parameter to apply, by their keys; absent: it always applies. */
	readonly where?: Readonly<Record<string, string>>;
}

interface NumericEntry extends CommonEntry {
	readonly min: number;
	readonly max: number;
	/** Values between 0 and this are raised to it. */
	readonly gapBelow?: number;
	readonly default: number;
	readonly step: number;
	/** The value in links from before `since`; the preset's value where absent. */
	readonly before?: number;
	/** The `#define` of the grammar that it replaces. */
	readonly define?: string;
}

export interface NumberEntry extends NumericEntry {
	readonly kind: "number" | "integer";
	/** The text displayed in place of 0, where 0 leaves the number to the grammar: "auto". */
	readonly zero?: string;
}

/** A choice among a few named options; its number is the option's index. */
export interface ChoiceEntry extends NumericEntry {
	readonly kind: "choice";
	/** Names as links write them. */
	readonly options: readonly string[];
}

export interface ColourEntry extends CommonEntry {
	readonly kind: "colour";
	/** Six hexadecimal digits, lower case. */
	readonly default: string;
}

/** One parameter: its label, range, and place in a link. */
export type ParameterEntry = NumberEntry | ChoiceEntry | ColourEntry;

/** The former name, in tables that were generated before the generator was changed. */
export type Entry = ParameterEntry;

/** A parameter that the core reads. */
export type CoreEntry = NumberEntry | ChoiceEntry;

/** Parameters that panels and pages show together. */
export interface Group {
	readonly key: string;
	readonly title: string;
	readonly help: string;
	/** Whether most users need it: such groups come before the numbers, the others after them. */
	readonly everyday?: boolean;
	/** Whether it is closed on a first visit. */
	readonly closed?: boolean;
	/** Whether it comes last in the panel: its contents appear and vanish while another control moves. */
	readonly last?: boolean;
	/** Whether the panel may omit its help. */
	readonly plain?: boolean;
}

/** A model's parameters and measures, made from its files in wasm-core/parameters. */
export class Table {
	/** Parameters that the core reads, in the order of its request. */
	readonly core: readonly CoreEntry[];
	/** Every link key once with its parameters, in the order of the table. */
	readonly links: ReadonlyMap<string, readonly ParameterEntry[]>;
	readonly #byKey: ReadonlyMap<string, ParameterEntry>;

	/**
	 * @param entries in the order of links and panels
	 * @param groups in the order of display
	 * @param measures in the order in which the core returns them
	 */
	constructor(
		readonly entries: readonly ParameterEntry[],
		readonly groups: readonly Group[],
		readonly measures: readonly MeasureInfo[] = [],
		readonly measureGroups: readonly MeasureGroup[] = [],
	) {
		this.core = entries.filter((entry) => !entry.look) as readonly CoreEntry[];
		this.links = groupByLink(entries);
		this.#byKey = new Map(entries.map((entry) => [entry.key, entry]));
	}

	/** The parameter of that key. */
	entry(key: string): ParameterEntry | undefined {
		return this.#byKey.get(key);
	}

	/** The parameters of a link key, in the order of its values; empty where the key is unknown. */
	linked(link: string): readonly ParameterEntry[] {
		return this.links.get(link) ?? [];
	}

	/** Whether a parameter or field applies with a specimen's choices. */
	isActive(specimen: Specimen, { where = {} }: Pick<ParameterEntry, "where">): boolean {
		return Object.entries(where).every(([key, option]) => this.option(specimen, key) === option);
	}

	/** The chosen option of a specimen, as links write it; undefined where there is no such choice. */
	option({ parameters }: Pick<Specimen, "parameters">, key: string): string | undefined {
		const entry = this.entry(key);
		return entry?.kind === "choice" ? entry.options[parameters[key]] : undefined;
	}
}

function groupByLink(entries: readonly ParameterEntry[]): Map<string, ParameterEntry[]> {
	const groups = new Map<string, ParameterEntry[]>();
	for (const entry of entries) {
		const group = groups.get(entry.link);
		if (group) group[entry.slot ?? group.length] = entry;
		else groups.set(entry.link, [entry]);
	}
	return groups;
}

/** The finest step of a link. Every specimen's values are multiples of it, so that its link gives the same specimen. */
const STEPS_PER_UNIT = 100;

/** The limits of a number. */
export type ValueRange = Pick<CoreEntry, "kind" | "min" | "max" | "gapBelow">;

/** The nearest value within the range that a link can hold. */
export function nearestWithin(range: ValueRange, value: number): number {
	const inside = Math.min(Math.max(value, range.min), range.max);
	const raised = inGap(range, inside) ? range.gapBelow : inside;
	return onStep(raised, range.kind === "number" ? STEPS_PER_UNIT : 1);
}

/** The nearest number that a link can hold. */
export function onStep(value: number, stepsPerUnit = STEPS_PER_UNIT): number {
	return Math.round(value * stepsPerUnit) / stepsPerUnit + 0; // −0 becomes 0
}

/** Whether a value lies between 0 and `gapBelow`, where no value is allowed. */
export function inGap(range: ValueRange, value: number): range is ValueRange & { gapBelow: number } {
	return range.gapBelow !== undefined && value > 0 && value < range.gapBelow;
}

/** The value of a parameter in a specimen. */
export function valueIn(
	{ look, parameters }: Pick<Specimen, "look" | "parameters">,
	entry: ParameterEntry,
): number | string {
	return entry.look ? look[entry.key] : parameters[entry.key];
}

/** The value of a parameter in a specimen as links and files write it: a choice by the name of its option. */
export function writtenIn(specimen: Pick<Specimen, "look" | "parameters">, entry: ParameterEntry): number | string {
	const value = valueIn(specimen, entry);
	return entry.kind === "choice" ? entry.options[value as number] : value;
}
