/**
 * Turns a request into a specimen. Values of a link are changed to fit, with notes, since the link may be old or
 * damaged; typed values that do not fit are refused, since a silent change would spoil a series.
 */
import { MessageError } from "../locale/message_error";
import type { Message } from "../locale/texts";
import { isModel, modelNamed, modelNames } from "../models/index";
import type { Model } from "../models/model";
import { fromPreset } from "../specimen/from_preset";
import { decodeLink, modelInQuery } from "../specimen/link";
import { quote } from "../specimen/notes";
import { isKnown, type Restored, restore } from "../specimen/restore";
import { SPECIMEN_VERSION, type Specimen } from "../specimen/specimen";
import { text } from "./messages.generated";

/** The request cannot be used as it is: nothing has been grown. The message names the problem and valid values. */
export class SpecimenError extends MessageError {
	override name = "SpecimenError";
	/** The problem as a sentence. */
	readonly problem: string;
	constructor(
		/** The name of the wrong part: a parameter's key, `preset`, `model`. */
		readonly key: string,
		problem: Message,
	) {
		super({ ...problem, text: text("at_key", { key, problem: problem.text }) });
		this.problem = problem.text;
	}
}

/** A specimen and its model. */
export interface Read extends Restored {
	readonly model: Model;
}

/**
 * Reads a preset's name or a link. A preset of the default model has its bare name, those of others their model's
 * before it: `riesling`, `leaf/oak`; a model's name alone means its standard preset, and an empty source the default
 * model's.
 * @param advice the last sentence of the message about an unknown preset
 * @throws SpecimenError where it is neither
 */
export async function readSource(source: string | undefined, advice = text("presets_listed")): Promise<Read> {
	const standard = await modelNamed();
	if (source === undefined || standard.presets.named(source)) return fresh(standard, source);
	const link = linkIn(source);
	if (link) return readLink(link.query, link.fragment);
	const [name, preset, ...rest] = source.split("/");
	if (!isModel(name) || rest.length > 0)
		throw new SpecimenError("preset", text.message("source_unknown", { source: quote(source), advice }));
	const model = await modelNamed(name);
	if (preset === undefined || model.presets.named(preset)) return fresh(model, preset);
	throw presetUnknown(model, preset, advice);
}

/** The error of a name that no model has. */
export const modelUnknown = (name: unknown): SpecimenError =>
	new SpecimenError("model", text.message("model_unknown", { model: quote(name), models: modelNames().join(", ") }));

/** Returns the error of a name that no preset of the model has. */
function presetUnknown({ name: model }: Model, preset: unknown, advice: string): SpecimenError {
	return new SpecimenError("preset", text.message("preset_unknown", { model, preset: quote(preset), advice }));
}

/** Query and fragment of a link, whole or from its `?` on; undefined where a text is none. */
export function linkIn(source: string): { query: string; fragment: string } | undefined {
	const hash = source.indexOf("#");
	const end = hash < 0 ? source.length : hash;
	const query = source.indexOf("?");
	if (query < 0 && hash < 0 && !source.includes("://")) return undefined;
	return { query: query < 0 ? "" : source.slice(query, end), fragment: source.slice(end) };
}

/** Reads a link; any link gives a complete specimen and notes. */
export async function readLink(query: string, fragment: string): Promise<Read> {
	const model = await modelNamed(modelInQuery(query));
	return { model, ...(await decodeLink(model, query, fragment)) };
}

/** Returns the specimen of a preset; of the standard one without a name. */
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
	const [{ key, code, args, problem }] = notes;
	if (isKnown(model, key)) throw new SpecimenError(key, { code, args, text: problem });
	throw new SpecimenError(key, text.message("parameter_unknown", { model: model.name }));
}

/**
 * Reads values by their keys, including the names of the model and of a preset.
 * @throws SpecimenError
 */
export async function readValues(values: Readonly<Record<string, unknown>>): Promise<Read> {
	const { model: name } = values;
	if (name !== undefined && !(typeof name === "string" && isModel(name))) throw modelUnknown(name);
	const model = await modelNamed(name as string | undefined);
	const { preset } = values;
	if (preset !== undefined && !(typeof preset === "string" && model.presets.named(preset)))
		throw presetUnknown(model, preset, text("presets_listed"));
	return { model, specimen: readTyped(model, { v: SPECIMEN_VERSION, ...values, model: model.name }), notes: [] };
}
