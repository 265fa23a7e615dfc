/** `grow`: what the library is for. */
import { aimed } from "../batch/aimed";
import { measuresOf } from "../formats/measures";
import { growPlant, untimed } from "../generate/growth";
import type { Model } from "../models/model";
import type { Plant } from "../plant/plant";
import { encodeLink } from "../specimen/link";
import { quote } from "../specimen/notes";
import type { Specimen as Held } from "../specimen/specimen";
import { writtenSpecimen } from "../specimen/written";
import { reachedInWords } from "../targets/words";
import { type Read, readSource, readValues, SpecimenError } from "./asked";
import { runtime } from "./runtime";

/**
 * A specimen: the whole document that a plant grows from. Plain JSON, the same as exported files carry and links write; the same
 * specimen gives the same plant, bit for bit, everywhere.
 */
export interface Specimen {
	/** The version of what it means. */
	readonly v: 2;
	/** Name of the model: `bunch`, `leaf`, `tree`, `root`. */
	readonly model: string;
	/** Name of the preset it started from. */
	readonly preset: string;
	/** 0 … 4294967295: another seed is another plant of the same shape. */
	readonly seed: number;
	/** Every parameter by its key, in the units of `parameters(model)`; choices by the names of their options. */
	readonly parameters: Readonly<Record<string, number | string>>;
	/** What only colours the plant: colours as six hexadecimal digits, the others numbers. */
	readonly look: Readonly<Record<string, number | string>>;
	/** What a model holds besides: berries taken off, a grammar's text, an outline. */
	readonly [detail: string]: unknown;
}

/**
 * What a program asks for by keys: `{ preset: "riesling", seed: 7, age: 80 }`. What is left out is the preset's; any key of
 * `parameters(model)` is one, and so are `grammar`, `thin` and the other details of docs/links.md. A whole `Specimen` is one, too.
 */
export interface Values {
	/** Name of the model; `bunch` where absent. */
	readonly model?: string;
	/** Name of one of its presets; the model's standard one where absent. */
	readonly preset?: string;
	/** 0 … 4294967295; 1 where absent. */
	readonly seed?: number;
	/** A parameter or a detail. */
	readonly [key: string]: unknown;
}

/**
 * What is to be grown: a link, whole or from its `?` on; a preset's name (`riesling`, `leaf/oak`, `tree` for a model's standard
 * preset); or values by their keys.
 */
export type Asked = string | Values;

/** How `grow` grows. */
export interface GrowOptions {
	/** Whether triangles are wanted; `true` where absent. Without them growing is quicker, and there are no parts and no files with meshes. */
	readonly meshes?: boolean;
	/** Whether measures are wanted; `true` where absent. */
	readonly measures?: boolean;
	/** Measures asked for in place of parameters, by their keys and in their units: `{ bunch_length: 160 }`. Parameters are found that measure so, as near as they can. */
	readonly targets?: Readonly<Record<string, number>>;
	/** Cancels. On a page a growth ends in its midst, elsewhere before it begins. */
	readonly signal?: AbortSignal;
}

/**
 * A grown specimen. Plain data: it may be posted from a worker to the page as it is, and `structuredClone` copies it.
 */
export interface Grown {
	/** What it grew from; of a link out of range, or with `targets`, not quite what was asked. */
	readonly specimen: Specimen;
	/** Query and fragment that bring it back: `?v=2&…`. */
	readonly link: string;
	/** In a few plain words: "118 berries, 14 cm long". */
	readonly words: string;
	/** How many of what there are, by name. */
	readonly counts: Readonly<Record<string, number>>;
	/** By the keys of `measures(model)` and in their units; null where one does not apply; empty where none were wanted. */
	readonly measures: Readonly<Record<string, number | null>>;
	/** What there is to say of what was asked and of what grew, in plain sentences. */
	readonly notes: readonly string[];
	/** 16 hexadecimal digits over segments and organs: the same plant has the same (docs/fingerprint.md). */
	readonly fingerprint: string;
	/** Whether it was grown with meshes, which its parts and most files are made of. */
	readonly meshes: boolean;
	/** The plant itself as typed arrays: segments, organs, meshes, and the model's own columns. Metres, +Y up. */
	readonly plant: Plant;
}

/**
 * Grows a specimen of any model.
 *
 * @param asked - a link, a preset's name, or values by their keys
 * @param options - what is wanted of it
 * @returns the plant with its measures, fingerprint, link and notes
 * @throws SpecimenError where a preset's name or a value cannot be used; what a link says is brought into range instead, with a note
 * @throws CoreError where a grammar's text is wrong, with its line and column, or the plant would be too large
 * @throws UnsupportedError where there is no WebAssembly, or the core's file could not be fetched
 * @throws CoreTrap where the core broke: the next plant grows in another
 *
 * @example
 * ```js
 * const bunch = await grow({ preset: "riesling", seed: 7, age: 80 });
 * ```
 */
export async function grow(asked: Asked, options: GrowOptions = {}): Promise<Grown> {
	const { model, specimen: from, notes } = await readAsked(asked);
	const { meshes = true, measures = true, targets = {}, signal } = options;
	const found = await aim(model, from, targets, signal);
	const plant = untimed(await growHeld(model, found.specimen, { meshes, measures }, signal));
	return {
		specimen: writtenSpecimen(model, found.specimen),
		link: await encodeLink(model, found.specimen),
		words: model.words(plant, found.specimen),
		counts: plant.counts,
		measures: measuresOf(model.table, plant).measures ?? {},
		notes: [...notes.map(({ text }) => text), ...found.notes, ...plant.notes],
		fingerprint: plant.fingerprint,
		meshes,
		plant,
	};
}

/** What is asked for, as a specimen with every parameter's value. */
export async function readAsked(asked: Asked): Promise<Read> {
	return typeof asked === "string" ? readSource(asked) : readValues(asked);
}

/** Grows what has been read. */
export function growHeld(
	model: Model,
	specimen: Held,
	wanted: { meshes: boolean; measures: boolean },
	signal?: AbortSignal,
): Promise<Plant> {
	return growPlant(model, specimen, wanted, (wasm, blocks) => runtime().grow(wasm, blocks, signal));
}

/** The specimen that measures what is asked, and what falls short of it. */
async function aim(model: Model, from: Held, targets: Readonly<Record<string, number>>, signal?: AbortSignal) {
	const aims = Object.entries(targets).map(([measure, value]) => ({ measure, value }));
	if (aims.length === 0) return { specimen: from, notes: [] };
	const known = model.targets?.measures(from) ?? [];
	for (const { measure, value } of aims) {
		if (!known.includes(measure))
			throw new SpecimenError(
				measure,
				`no measure of this ${model.noun} that can be asked for; there are ${known.join(", ") || "none"}`,
			);
		if (!(value >= 0 && Number.isFinite(value)))
			throw new SpecimenError(measure, `${quote(value)} is no number from 0 on`);
	}
	const answer = await aimed(model, from, aims, (each) =>
		growHeld(model, each, { meshes: false, measures: true }, signal),
	);
	const short = answer.reached.filter(({ there }) => !there);
	return { specimen: answer.specimen, notes: short.map((each) => `${reachedInWords(each)}.`) };
}
