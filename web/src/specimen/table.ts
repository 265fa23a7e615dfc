/** Parameter tables (wasm-core/parameters/<model>.json), typed for look-up, and the one rule by which a value fits one. */
import type { MeasureGroup, MeasureInfo } from "./measures";
import type { Specimen } from "./specimen";

interface Common {
	readonly key: string;
	/** Key in the link, for ever. Parameters that share one are its comma-separated values, by `slot`. */
	readonly link: string;
	readonly slot?: number;
	readonly label: string;
	/** The paper's symbol, or empty. */
	readonly symbol: string;
	/** The key of its group. */
	readonly group: string;
	/** Empty for choices and colours. */
	readonly unit: string;
	/** One plain sentence. */
	readonly help: string;
	/** The link version that first knew it. */
	readonly since: number;
	/** Whether it only colours the result. */
	readonly look?: boolean;
	/** The options of choices that must hold for it to be heeded, by their keys; absent where it always is. */
	readonly where?: Readonly<Record<string, string>>;
}

interface Numeric extends Common {
	readonly min: number;
	readonly max: number;
	/** Between 0 and this lies nothing: a value there is raised to it. */
	readonly gapBelow?: number;
	readonly default: number;
	readonly step: number;
	/** What a link from before `since` means; the preset's value where absent. */
	readonly before?: number;
	/** The `#define` of the grammar that it replaces. */
	readonly define?: string;
}

export interface NumberEntry extends Numeric {
	readonly kind: "number" | "integer";
	/** What is read in place of 0, where that leaves a number to the text: "auto". */
	readonly zero?: string;
}

/** One of a few named options; its number is the place among them. */
export interface ChoiceEntry extends Numeric {
	readonly kind: "choice";
	/** As links write them. */
	readonly options: readonly string[];
}

export interface ColourEntry extends Common {
	readonly kind: "colour";
	/** Six hexadecimal digits, lower case. */
	readonly default: string;
}

/** One parameter: what it is called, what it may be, and where it stands in a link. */
export type Entry = NumberEntry | ChoiceEntry | ColourEntry;

/** One that the core reads. */
export type CoreEntry = NumberEntry | ChoiceEntry;

/** Parameters that panels and pages show together. */
export interface Group {
	readonly key: string;
	readonly title: string;
	readonly help: string;
	/** Whether most people touch it: such groups stand before the numbers, the others after them. */
	readonly everyday?: boolean;
	/** Whether a first visit finds it closed. */
	readonly closed?: boolean;
	/** Whether it stands at the panel's end: what comes and goes while a hand moves something else. */
	readonly last?: boolean;
	/** Whether the panel may do without its help. */
	readonly plain?: boolean;
}

/** A model's parameters and measures, made from its files in wasm-core/parameters. */
export class Table {
	/** Those that the core reads, in the order of its request. */
	readonly core: readonly CoreEntry[];
	/** Every link key once, in the order of the table, with its parameters. */
	readonly links: ReadonlyMap<string, readonly Entry[]>;
	readonly #byKey: ReadonlyMap<string, Entry>;

	/**
	 * @param entries in the order of links and panels
	 * @param groups in the order in which they are shown
	 * @param measures in the order in which the core gives them
	 */
	constructor(
		readonly entries: readonly Entry[],
		readonly groups: readonly Group[],
		readonly measures: readonly MeasureInfo[] = [],
		readonly measureGroups: readonly MeasureGroup[] = [],
	) {
		this.core = entries.filter((entry) => !entry.look) as readonly CoreEntry[];
		this.links = groupByLink(entries);
		this.#byKey = new Map(entries.map((entry) => [entry.key, entry]));
	}

	/** The parameter of that key. */
	entry(key: string): Entry | undefined {
		return this.#byKey.get(key);
	}

	/** The parameters that a link key stands for, in the order of its values; empty where the key is unknown. */
	linked(link: string): readonly Entry[] {
		return this.links.get(link) ?? [];
	}

	/** Whether a specimen's choices let it heed something. */
	isActive(specimen: Specimen, { where = {} }: Pick<Entry, "where">): boolean {
		return Object.entries(where).every(([key, option]) => this.option(specimen, key) === option);
	}

	/** The option that a specimen has chosen, as links write it; undefined where there is no such choice. */
	option({ parameters }: Pick<Specimen, "parameters">, key: string): string | undefined {
		const entry = this.entry(key);
		return entry?.kind === "choice" ? entry.options[parameters[key]] : undefined;
	}
}

function groupByLink(entries: readonly Entry[]): Map<string, Entry[]> {
	const groups = new Map<string, Entry[]>();
	for (const entry of entries) {
		const group = groups.get(entry.link);
		if (group) group[entry.slot ?? group.length] = entry;
		else groups.set(entry.link, [entry]);
	}
	return groups;
}

/** The finest step a link can hold. Every specimen lies on it, so that its link is the same specimen. */
const STEPS_PER_UNIT = 100;

/** What bounds a number. */
export type Range = Pick<CoreEntry, "kind" | "min" | "max" | "gapBelow">;

/** The nearest value that the range allows and a link can hold. */
export function nearestWithin(range: Range, value: number): number {
	const inside = Math.min(Math.max(value, range.min), range.max);
	const raised = inGap(range, inside) ? range.gapBelow : inside;
	return onStep(raised, range.kind === "number" ? STEPS_PER_UNIT : 1);
}

/** The nearest number that a link can hold. */
export function onStep(value: number, stepsPerUnit = STEPS_PER_UNIT): number {
	return Math.round(value * stepsPerUnit) / stepsPerUnit + 0; // −0 becomes 0
}

/** Whether a value lies between 0 and `gapBelow`, where nothing is. */
export function inGap(range: Range, value: number): range is Range & { gapBelow: number } {
	return range.gapBelow !== undefined && value > 0 && value < range.gapBelow;
}

/** What a specimen holds for a parameter. */
export function valueIn({ look, parameters }: Pick<Specimen, "look" | "parameters">, entry: Entry): number | string {
	return entry.look ? look[entry.key] : parameters[entry.key];
}

/** What a specimen holds for a parameter, as links and files write it: a choice by the name of its option. */
export function writtenIn(specimen: Pick<Specimen, "look" | "parameters">, entry: Entry): number | string {
	const value = valueIn(specimen, entry);
	return entry.kind === "choice" ? entry.options[value as number] : value;
}
