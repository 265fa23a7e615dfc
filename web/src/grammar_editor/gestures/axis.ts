/** Axes that gestures can control: numeric parameters of the table, and constants of the document's text. */
import { displayScaleOf } from "../../specimen/lengths";
import { nearestWithin } from "../../specimen/table";
import type { Change, EditorState } from "../../ui/editor_context";
import { decimals } from "../outline";
import { readOutline } from "../read_outline";
import { written } from "../scrub";
import { type GrammarContext, type GrammarSource, textOf, withValues } from "../source";

/** A number of the document, with its range. */
export interface Axis {
	/** A name that no other axis of the document has: `parameter age`, `constant length`. */
	readonly id: string;
	readonly label: string;
	/** The value as text, with its unit. */
	readonly read: string;
	readonly min: number;
	readonly max: number;
	readonly step: number;
	readonly value: number;
}

/** Axes of a document, and the changes that set them. */
export class Axes {
	readonly #context: GrammarContext;
	readonly #source: GrammarSource | undefined;
	readonly #later: () => void;

	/**
	 * @param source source of the text whose constants are axes; absent if there is none
	 * @param later called after the text has loaded and its axes exist
	 */
	constructor(context: GrammarContext, source: GrammarSource | undefined, later: () => void) {
		this.#context = context;
		this.#source = source;
		this.#later = later;
	}

	/** All axes of the current document, those of the text first. */
	get all(): readonly Axis[] {
		return [...this.#constants, ...parametersOf(this.#context.state)];
	}

	/** Returns the change that sets axes to values, rounded to their steps. */
	to(values: ReadonlyMap<string, number>): Change {
		const parameters: Record<string, number> = {};
		// Names in a text can be any word, including `__proto__`.
		const constants: Record<string, number> = Object.create(null);
		for (const { id, min, max, step } of this.all) {
			const value = values.get(id);
			if (value === undefined) continue;
			const [kind, key] = id.split(" ");
			const entry = this.#context.state.model.table.entry(key);
			if (kind === "constant") constants[key] = Number(written(onSteps(value, min, max, step), decimals(String(step))));
			else if (entry && entry.kind !== "colour") parameters[key] = nearestWithin(entry, value);
		}
		const given = this.#source && Object.keys(constants).length > 0;
		return { parameters, ...(given ? withValues(this.#source, this.#context.state.specimen, constants) : {}) };
	}

	/** The document's text; undefined while it loads, or without a text. */
	get #text(): string | undefined {
		return this.#source && textOf(this.#source, this.#context.state.specimen, this.#later);
	}

	/** Constants of the text as axes, without those that a parameter governs. */
	get #constants(): readonly Axis[] {
		const text = this.#text;
		if (text === undefined || !this.#source) return [];
		const { governed } = this.#source;
		return readOutline(text, this.#source.dialect)
			.constants.filter(({ name }) => !governed?.has(name))
			.map(({ name, number, min, max, step }) => {
				return { id: `constant ${name}`, label: name, read: number.text, min, max, step, value: number.value };
			});
	}
}

/** Returns the numeric parameters that have an effect on the specimen; look parameters are left out. */
function parametersOf({ model, specimen }: EditorState): readonly Axis[] {
	return model.table.entries.flatMap((entry) => {
		if (entry.look || (entry.kind !== "number" && entry.kind !== "integer")) return [];
		if (!model.table.isActive(specimen, entry)) return [];
		const { key, label, min, max, step } = entry;
		const value = specimen.parameters[key];
		const { unit, per } = displayScaleOf(model, specimen, entry);
		const read = `${Number((value * per).toPrecision(6))} ${unit}`.trim();
		return [{ id: `parameter ${key}`, label, read, min, max, step, value }];
	});
}

/** Returns the position of an axis in its range: 0 … 1. */
export function shareOf({ value, min, max }: Axis): number {
	return max > min ? (value - min) / (max - min) : 0;
}

/** Returns the value of an axis at a share of its range. */
export function atShare({ min, max }: Axis, share: number): number {
	return min + (max - min) * Math.min(Math.max(share, 0), 1);
}

/** Returns the value on the nearest step from `min`, within the range. */
function onSteps(value: number, min: number, max: number, step: number): number {
	return Math.min(Math.max(min + Math.round((value - min) / step) * step, min), max);
}
