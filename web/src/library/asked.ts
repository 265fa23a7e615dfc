/**
 * What is asked for → a specimen. A link is brought into range with notes, since it may be old or cut short on its way;
 * what was typed is refused where it cannot be used, since a silent change would spoil a series.
 */
import { isModel, modelNamed, modelNames } from "../models/index";
import type { Model } from "../models/model";
import { fromPreset } from "../specimen/from_preset";
import { decodeLink, modelInQuery } from "../specimen/link";
import { quote } from "../specimen/notes";
import { isKnown, type Restored, restore } from "../specimen/restore";
import { SPECIMEN_VERSION, type Specimen } from "../specimen/specimen";

/** What was asked for cannot be used as it is: nothing has been grown. The message says what is wrong, and what there is in its place. */
export class SpecimenError extends Error {
	override name = "SpecimenError";
	constructor(
		/** The part that is wrong, as it was named: a parameter's key, `preset`, `model`. */
		readonly key: string,
		/** What is wrong with it, in plain words. */
		readonly problem: string,
		message = `${key}: ${problem}`,
	) {
		super(message);
	}
}

/** A specimen, and the model that it is one of. */
export interface Read extends Restored {
	readonly model: Model;
}

/** Where a text says how its presets are listed. */
const LISTED = "presets() lists them";

/**
 * A preset's name or a link. A preset of the default model has its bare name, those of others their model's before it:
 * `riesling`, `leaf/oak`; a model's name alone is its standard preset, and nothing the default model's.
 * @param listed ends the sentence about a preset that is not there
 * @throws SpecimenError where it is neither
 */
export async function readSource(source: string | undefined, listed = LISTED): Promise<Read> {
	const standard = await modelNamed();
	if (source === undefined || standard.presets.named(source)) return fresh(standard, source);
	const link = linkIn(source);
	if (link) return readLink(link.query, link.fragment);
	const [name, preset, ...rest] = source.split("/");
	if (!isModel(name) || rest.length > 0) {
		const problem = `${quote(source)} is neither a preset nor a link`;
		throw new SpecimenError("preset", problem, `${problem}; ${listed}`);
	}
	const model = await modelNamed(name);
	if (preset === undefined || model.presets.named(preset)) return fresh(model, preset);
	const problem = `the ${model.noun} has no preset ${quote(preset)}`;
	throw new SpecimenError("preset", problem, `${quote(source)}: ${problem}; ${listed}`);
}

/** Query and fragment of a link, whole or from its `?` on; undefined where a text is none. */
export function linkIn(text: string): { query: string; fragment: string } | undefined {
	const hash = text.indexOf("#");
	const end = hash < 0 ? text.length : hash;
	const query = text.indexOf("?");
	if (query < 0 && hash < 0 && !text.includes("://")) return undefined;
	return { query: query < 0 ? "" : text.slice(query, end), fragment: text.slice(end) };
}

/** Reads a link; whatever comes in gives a complete specimen and notes. */
export async function readLink(query: string, fragment: string): Promise<Read> {
	const model = await modelNamed(modelInQuery(query));
	return { model, ...(await decodeLink(model, query, fragment)) };
}

function fresh(model: Model, preset: string | undefined): Read {
	return { model, specimen: fromPreset(model, preset), notes: [] };
}

/**
 * Values by their keys, as a person or a program writes them, put into a specimen; the first that cannot be used as it is
 * ends it. Numbers are held to two decimals, as links hold them.
 * @param from what holds where they are silent; without one, the preset that they name
 * @throws SpecimenError
 */
export function readTyped(model: Model, values: Readonly<Record<string, unknown>>, from?: Specimen): Specimen {
	const { specimen, notes } = restore(model, values, from);
	if (notes.length === 0) return specimen;
	const [{ key, problem }] = notes;
	if (isKnown(model, key)) throw new SpecimenError(key, problem);
	throw new SpecimenError(key, `no parameter of the ${model.noun} has that key; parameters() lists them`);
}

/**
 * Values by their keys, among them the model's name and a preset's.
 * @throws SpecimenError
 */
export async function readValues(values: Readonly<Record<string, unknown>>): Promise<Read> {
	const { model: name } = values;
	if (name !== undefined && !(typeof name === "string" && isModel(name)))
		throw new SpecimenError("model", `there is no model ${quote(name)}; there are ${modelNames().join(", ")}`);
	const model = await modelNamed(name as string | undefined);
	const { preset } = values;
	if (preset !== undefined && !(typeof preset === "string" && model.presets.named(preset)))
		throw new SpecimenError("preset", `the ${model.noun} has no preset ${quote(preset)}; ${LISTED}`);
	return { model, specimen: readTyped(model, { v: SPECIMEN_VERSION, ...values, model: model.name }), notes: [] };
}
