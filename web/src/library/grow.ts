/** `grow`, the main function of the library. */
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
import { text } from "./messages.generated";
import { type Read, readSource, readValues, SpecimenError } from "./read_request";
import { runtime } from "./runtime";

/**
 * A specimen: the whole document that a plant grows from. Plain JSON, the same as in exported files and links; the same
 * specimen gives the same plant, bit for bit, everywhere.
 */
export interface Specimen {
	/** The version of its meaning. */
	readonly v: 2;
	/** Name of the model: `bunch`, `leaf`, `tree`, `root`. */
	readonly model: string;
	/** Name of the preset it started from. */
	readonly preset: string;
	/** 0 … 4294967295: another seed is another plant of the same shape. */
	readonly seed: number;
	/** Every parameter by its key, in the units of `parameters(model)`; choices by the names of their options. */
	readonly parameters: Readonly<Record<string, number | string>>;
	/** Values that only colour the plant: colours as six hexadecimal digits, the others numbers. */
	readonly look: Readonly<Record<string, number | string>>;
	/** Further fields of the model: removed berries, a grammar's text, an outline. */
	readonly [detail: string]: unknown;
}

/**
 * Values by keys: `{ preset: "riesling", seed: 7, age: 80 }`. Missing ones are the preset's; keys are those of
 * `parameters(model)`, and `grammar`, `thin` and the other fields in docs/links.md. A whole `Specimen` is valid, too.
 */
export interface Values {
	/** Name of the model; `bunch` where absent. */
	readonly model?: string;
	/** Name of one of its presets; the model's standard one where absent. */
	readonly preset?: string;
	/** 0 … 4294967295; 1 where absent. */
	readonly seed?: number;
	/** A parameter or a further field. */
	readonly [key: string]: unknown;
}

/**
 * A request for a plant: a link, whole or from its `?` on; a preset's name (`riesling`, `leaf/oak`, `tree` for a
 * model's standard preset); or values by their keys.
 */
export type PlantRequest = string | Values;

/** Options of `grow`. */
export interface GrowOptions {
	/**
	 * Whether to make triangles; `true` where absent. Without them growing is quicker, and there are no parts and no
	 * files with meshes.
	 */
	readonly meshes?: boolean;
	/** Whether to measure the plant; `true` where absent. */
	readonly measures?: boolean;
	/**
	 * Target measures in place of parameters, by their keys and in their units: `{ bunch_length: 160 }`. `grow`
	 * searches for parameters that come as near as possible.
	 */
	readonly targets?: Readonly<Record<string, number>>;
	/** Cancels. On a page it interrupts a growth, elsewhere it only prevents one from beginning. */
	readonly signal?: AbortSignal;
}

/**
 * A grown specimen. Plain data: it may be posted from a worker to the page as it is, and `structuredClone` copies it.
 */
export interface Grown {
	/** The specimen that it grew from; it differs from the request for a link out of range, or with `targets`. */
	readonly specimen: Specimen;
	/** Query and fragment that restore it: `?v=2&…`. */
	readonly link: string;
	/** A few plain words: "14 cm long, with 118 berries". */
	readonly words: string;
	/** Counts by name. */
	readonly counts: Readonly<Record<string, number>>;
	/**
	 * By the keys of `measures(model)` and in their units; null where one does not apply; empty where none were
	 * requested.
	 */
	readonly measures: Readonly<Record<string, number | null>>;
	/** Messages about the request and the plant, in plain sentences. */
	readonly notes: readonly string[];
	/** 16 hexadecimal digits over segments and organs: equal for equal plants (docs/fingerprint.md). */
	readonly fingerprint: string;
	/** Whether it was grown with meshes, which parts and most files need. */
	readonly meshes: boolean;
	/** The plant itself as typed arrays: segments, organs, meshes, and the model's own columns. Metres, +Y up. */
	readonly plant: Plant;
}

/**
 * Grows a specimen of any model.
 * @param request - a link, a preset's name, or values by their keys
 * @param options - options of growing
 * @returns the plant with its measures, fingerprint, link and notes
 * @throws SpecimenError where a preset's name or a value cannot be used; values of a link are brought into range
 * instead, with a note
 * @throws CoreError where a grammar's text is wrong, with its line and column, or the plant would be too large
 * @throws UnsupportedError where there is no WebAssembly, or the core's file could not be fetched
 * @throws CoreTrap where the core crashed: the next plant grows in another
 *
 * @example
 * ```js
 * const bunch = await grow({ preset: "riesling", seed: 7, age: 80 });
 * ```
 */
export async function grow(request: PlantRequest, options: GrowOptions = {}): Promise<Grown> {
	const { model, specimen: from, notes } = await readRequest(request);
	const { meshes = true, measures = true, targets = {}, signal } = options;
	const found = await aim(model, from, targets, signal);
	const plant = untimed(await growHeld(model, found.specimen, { meshes, measures }, signal));
	return {
		specimen: writtenSpecimen(model, found.specimen),
		link: await encodeLink(model, found.specimen),
		words: model.summary(plant, found.specimen),
		counts: plant.counts,
		measures: measuresOf(model.table, plant).measures ?? {},
		notes: [...notes.map((note) => note.text), ...found.notes, ...plant.notes],
		fingerprint: plant.fingerprint,
		meshes,
		plant,
	};
}

/** The request as a specimen with every parameter's value. */
export async function readRequest(request: PlantRequest): Promise<Read> {
	return typeof request === "string" ? readSource(request) : readValues(request);
}

/** Grows a specimen that has been read. */
export function growHeld(
	model: Model,
	specimen: Held,
	wanted: { meshes: boolean; measures: boolean },
	signal?: AbortSignal,
): Promise<Plant> {
	return growPlant(model, specimen, wanted, (wasm, blocks) => runtime().grow(wasm, blocks, signal));
}

/** The specimen nearest to the targets, and notes on missed ones. */
async function aim(model: Model, from: Held, targets: Readonly<Record<string, number>>, signal?: AbortSignal) {
	const aims = Object.entries(targets).map(([measure, value]) => ({ measure, value }));
	if (aims.length === 0) return { specimen: from, notes: [] };
	const known = model.targets?.measures(from) ?? [];
	for (const { measure, value } of aims) {
		if (!known.includes(measure))
			throw new SpecimenError(
				measure,
				known.length > 0
					? text.message("measure_unknown", { measures: known.join(", ") })
					: text.message("no_measures"),
			);
		if (!(value >= 0 && Number.isFinite(value)))
			throw new SpecimenError(measure, text.message("target_not_a_number", { value: quote(value) }));
	}
	const answer = await aimed(model, from, aims, (each) =>
		growHeld(model, each, { meshes: false, measures: true }, signal),
	);
	const short = answer.reached.filter(({ isReached }) => !isReached);
	return { specimen: answer.specimen, notes: short.map((each) => `${reachedInWords(each)}.`) };
}
