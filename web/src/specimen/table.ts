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
	/** Place among the basics, which the panel shows first; absent: the panel shows it under "Advanced". */
	readonly basic?: number;
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
	/** The options' names for people, in the same order. */
	readonly labels?: readonly string[];
}

export interface ColourEntry extends CommonEntry {
	readonly kind: "colour";
	/** Six hexadecimal digits, lower case. */
	readonly default: string;
}

/** One parameter: its label, range, and place in a link. */
export type ParameterEntry = NumberEntry | ChoiceEntry | ColourEntry;

/** A parameter that the core reads. */
export type CoreEntry = NumberEntry | ChoiceEntry;

/** Parameters that panels and pages show together. */
export interface Group {
	readonly key: string;
	readonly title: string;
	readonly help: string;
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

	/** Returns the parameter of that key; undefined if there is none. */
	entry(key: string): ParameterEntry | undefined {
		return this.#byKey.get(key);
	}

	/** Returns the parameters of a link key, in the order of its values; empty where the key is unknown. */
	linked(link: string): readonly ParameterEntry[] {
		return this.links.get(link) ?? [];
	}

	/** The parameters that a first-time user needs, in their order. */
	get basics(): readonly ParameterEntry[] {
		const marked = this.entries.filter(({ basic }) => basic !== undefined);
		return marked.sort((one, other) => Number(one.basic) - Number(other.basic));
	}

	/** Returns whether a parameter or field applies with a specimen's choices. */
	isActive(specimen: Specimen, { where = {} }: Pick<ParameterEntry, "where">): boolean {
		return Object.entries(where).every(([key, option]) => this.option(specimen, key) === option);
	}

	/** Returns the chosen option of a specimen, as links write it; undefined where there is no such choice. */
	option(specimen: Pick<Specimen, "look" | "parameters">, key: string): string | undefined {
		const entry = this.entry(key);
		return entry?.kind === "choice" ? entry.options[valueIn(specimen, entry) as number] : undefined;
	}
}

/** Groups parameters by link key; those that share a key are in the order of their slots. */
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

/** Returns the nearest value that is within a range and that a link can hold. */
export function nearestWithin(range: ValueRange, value: number): number {
	const inside = Math.min(Math.max(value, range.min), range.max);
	const raised = inGap(range, inside) ? range.gapBelow : inside;
	return onStep(raised, range.kind === "number" ? STEPS_PER_UNIT : 1);
}

/** Returns the nearest multiple of a step; the default is the finest step of a link, 0.01. */
export function onStep(value: number, stepsPerUnit = STEPS_PER_UNIT): number {
	return Math.round(value * stepsPerUnit) / stepsPerUnit + 0; // −0 becomes 0
}

/** Returns whether a value lies between 0 and `gapBelow`, where no value is allowed. */
export function inGap(range: ValueRange, value: number): range is ValueRange & { gapBelow: number } {
	return range.gapBelow !== undefined && value > 0 && value < range.gapBelow;
}

/** Returns the value of a parameter in a specimen; a choice is the index of its option. */
export function valueIn(
	{ look, parameters }: Pick<Specimen, "look" | "parameters">,
	entry: ParameterEntry,
): number | string {
	return entry.look ? look[entry.key] : parameters[entry.key];
}

/** Returns the value of a parameter in a specimen as links and files write it: a choice by the name of its option. */
export function writtenIn(specimen: Pick<Specimen, "look" | "parameters">, entry: ParameterEntry): number | string {
	const value = valueIn(specimen, entry);
	return entry.kind === "choice" ? entry.options[value as number] : value;
}
