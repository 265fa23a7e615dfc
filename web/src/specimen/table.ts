/** The parameter table (wasm-core/parameters/bunch.json), typed for look-up, and the one rule by which a value fits it. */
import type { Procedure } from "../models/bunch/grown";
import {
	LOOK_KEYS,
	type LookKey,
	type NumberKey,
	PARAMETERS,
	type ParameterKey,
} from "../models/bunch/parameters.generated";
import type { Specimen } from "./specimen";

interface Common {
	key: ParameterKey;
	/** Short key in links; two parameters of one control point share it and are told apart by `slot`. */
	link: string;
	slot?: number;
	/** The link version that first knew it. */
	since: number;
}

interface Numeric extends Common {
	min: number;
	max: number;
	/** Between 0 and this lies nothing: a value there is raised to it. */
	gapBelow?: number;
	default: number;
	/** What a link from before `since` means; the preset's value where absent. */
	before?: number;
	/** The `#define` of the grammar that it replaces. */
	define?: string;
	/** The one procedure that heeds it; absent where both do. */
	procedure?: Procedure;
}

export interface NumberEntry extends Numeric {
	kind: "number" | "integer";
}

/** One of a few named options; its number is the place among them. */
export interface ChoiceEntry extends Numeric {
	kind: "choice";
	options: readonly string[];
}

export interface ColourEntry extends Common {
	kind: "colour";
	/** Six hexadecimal digits, lower case. */
	default: string;
}

export type Entry = NumberEntry | ChoiceEntry | ColourEntry;

/** Every parameter, in the order of the table, which is the order of links and of the core's request. */
export const ENTRIES = PARAMETERS as readonly Entry[];

export type CoreEntry = (NumberEntry | ChoiceEntry) & { key: NumberKey };

/** Those that the core reads. */
export const CORE_ENTRIES = ENTRIES.filter((entry) => !isLook(entry.key)) as readonly CoreEntry[];

/** Whether a parameter only colours the result. */
export function isLook(key: ParameterKey): key is LookKey {
	return (LOOK_KEYS as readonly string[]).includes(key);
}

const byKey = new Map<string, Entry>(ENTRIES.map((entry) => [entry.key, entry]));

/** The parameter of that table key. */
export function entryOf(key: string): Entry | undefined {
	return byKey.get(key);
}

/** The parameters that a link key stands for, in the order of its values; empty where the key is unknown. */
export function entriesOfLink(link: string): readonly Entry[] {
	return byLink.get(link) ?? [];
}

/** Every link key once, in the order of the table, with its parameters. */
export const byLink: ReadonlyMap<string, readonly Entry[]> = groupByLink();

function groupByLink(): Map<string, Entry[]> {
	const groups = new Map<string, Entry[]>();
	for (const entry of ENTRIES) {
		const group = groups.get(entry.link);
		if (group) group[entry.slot ?? group.length] = entry;
		else groups.set(entry.link, [entry]);
	}
	return groups;
}

/** The finest step a link can hold. Every specimen lies on it, so that its link is the same specimen. */
const STEPS_PER_UNIT = 100;

/** What bounds a number. */
export type Range = Pick<NumberEntry | ChoiceEntry, "kind" | "min" | "max" | "gapBelow">;

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
export function valueIn(specimen: Specimen, entry: Entry): number | string {
	return isLook(entry.key) ? specimen.look[entry.key] : specimen.parameters[entry.key];
}

/** What a specimen holds for a parameter, as links and files write it: a choice by the name of its option. */
export function writtenIn(specimen: Specimen, entry: Entry): number | string {
	const value = valueIn(specimen, entry);
	return entry.kind === "choice" ? entry.options[value as number] : value;
}

/** By which procedure a specimen grows. */
export function procedureOf(specimen: Specimen): Procedure {
	return writtenIn(specimen, entryOf("procedure") as Entry) as Procedure;
}
