/**
 * Turns a request into a specimen. Values of a link are changed to fit, with notes, since the link may be old or
 * damaged; typed values that do not fit are refused, since a silent change would spoil a series.
 */
import { isModel, modelNamed, modelNames } from "../models/index";
import type { Model } from "../models/model";
import { fromPreset } from "../specimen/from_preset";
import { decodeLink, modelInQuery } from "../specimen/link";
import { quote } from "../specimen/notes";
import { isKnown, type Restored, restore } from "../specimen/restore";
import { SPECIMEN_VERSION, type Specimen } from "../specimen/specimen";

/** The request cannot be used as it is: nothing has been grown. The message names the problem and valid values. */
export class SpecimenError extends Error {
	override name = "SpecimenError";
	constructor(
		/** The name of the wrong part: a parameter's key, `preset`, `model`. */
		readonly key: string,
		/** The problem in plain words. */
		readonly problem: string,
		message = `${key}: ${problem}`,
	) {
		super(message);
	}
}

/** A specimen and its model. */
export interface Read extends Restored {
	readonly model: Model;
}

/** A hint in messages about unknown presets. */
const LISTED = "presets() lists them";

/**
 * Reads a preset's name or a link. A preset of the default model has its bare name, those of others their model's
 * before it: `riesling`, `leaf/oak`; a model's name alone means its standard preset, and an empty source the default
 * model's.
 * @param listed the end of the message about an unknown preset
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

/** Reads a link; any link gives a complete specimen and notes. */
export async function readLink(query: string, fragment: string): Promise<Read> {
	const model = await modelNamed(modelInQuery(query));
	return { model, ...(await decodeLink(model, query, fragment)) };
}

function fresh(model: Model, preset: string | undefined): Read {
	return { model, specimen: fromPreset(model, preset), notes: [] };
}

/**
 * Sets values by their keys in a specimen; throws at the first that cannot be used as it is. Numbers are rounded to two
 * decimals, as in links.
 * @param from the specimen with all other values; without one, the preset that the values name
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
 * Reads values by their keys, including the names of the model and of a preset.
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
