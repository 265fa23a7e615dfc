/** The catalogue: models, and their presets, parameters, measures and files. */
import { PLANT_FILES } from "../formats/plant_files";
import { type ParameterInfo, parametersOf } from "../models/catalogue";
import { isModel, modelNamed, modelNames } from "../models/index";
import type { Model } from "../models/model";
import { text } from "./messages.generated";
import { modelUnknown } from "./read_request";

export type { ParameterInfo } from "../models/catalogue";

/** A model. */
export interface ModelInfo {
	/** The name in links: `bunch`. */
	readonly name: string;
	/** The heading: "Grape bunch". */
	readonly title: string;
	/** Whether the meaning of its links is not frozen yet. */
	readonly preview: boolean;
}

/** A named specimen to start from. */
export interface PresetInfo {
	/** The name in links: `long-conical`. */
	readonly name: string;
	/** The heading. */
	readonly title: string;
	/** The gallery's group of it. */
	readonly kind: string;
	/** One line of description. */
	readonly about: string;
}

/** A measure of a grown plant. */
export interface MeasureInfo {
	/** The key in `Grown.measures` and `CancelOptions.targets`. */
	readonly key: string;
	/** The label in tables. */
	readonly label: string;
	/** A share is 0 … 1; a note is the class of a descriptor. */
	readonly kind: "number" | "share" | "whole" | "note";
	/** Empty for shares, counts and notes. */
	readonly unit: string;
	/** Code of the descriptor of the OIV, the vine and wine organisation, if there is one. */
	readonly oiv?: number;
	/** One plain sentence. */
	readonly help: string;
}

/** A kind of file. */
export interface FormatInfo {
	/** The key for `toFile`: `glb-low`, `csv`. */
	readonly key: string;
	/** The title in menus. */
	readonly title: string;
	/** One line of description. */
	readonly about: string;
	/** The end of such files' names: `-low.glb`. */
	readonly suffix: string;
	/** The media type. */
	readonly type: string;
}

/** All models; the default model is the first. */
export async function models(): Promise<ModelInfo[]> {
	const all = await Promise.all(modelNames().map(modelNamed));
	return all.map(({ name, title, preview = false }) => ({ name, title, preview }));
}

/**
 * The presets of a model, in the order of the gallery.
 *
 * @param model - its name; the default model's where absent
 * @throws SpecimenError where there is no such model
 */
export async function presets(model?: string): Promise<PresetInfo[]> {
	const { presets: of } = await knownModel(model);
	return of.list.map(({ name, title, kind, about }) => ({ name, title, kind, about }));
}

/**
 * The parameters of a model, in the order of its panel.
 *
 * @param model - its name; the default model's where absent
 * @throws SpecimenError where there is no such model
 */
export async function parameters(model?: string): Promise<ParameterInfo[]> {
	return parametersOf(await knownModel(model));
}

/**
 * The measures of a model's plants.
 *
 * @param model - its name; the default model's where absent
 * @throws SpecimenError where there is no such model
 */
export async function measures(model?: string): Promise<MeasureInfo[]> {
	const { table } = await knownModel(model);
	return table.measures.map(({ key, label, kind, unit, help, oiv }) => ({
		key,
		label,
		kind,
		unit,
		help,
		...(oiv === undefined ? {} : { oiv }),
	}));
}

/**
 * The kinds of file that `toFile` makes of a model's plants. Some do not suit all plants: `glb-growth` needs an age,
 * `glb-lod` a model with levels, and `zip-game` a tree with leaves.
 * @param model - its name; the default model's where absent
 * @throws SpecimenError where there is no such model
 */
export async function formats(model?: string): Promise<FormatInfo[]> {
	const { formats: own = [] } = await knownModel(model);
	const files = PLANT_FILES.map((file) => ({ ...file, title: file.title(), about: file.about() }));
	return [...files, ...others(), ...own].map(({ key, title, about, suffix, type }) => ({
		key,
		title,
		about,
		suffix,
		type,
	}));
}

/** Returns the kinds of files besides those with meshes in one piece. */
const others = (): readonly FormatInfo[] => [
	{
		key: "obj",
		title: text("obj_title"),
		about: text("obj_about"),
		suffix: "-obj.zip",
		type: "application/zip",
	},
	{
		key: "json",
		title: text("json_title"),
		about: text("json_about"),
		suffix: ".json",
		type: "application/json",
	},
];

/**
 * Returns the model of a name; the default model without one.
 * @throws SpecimenError where there is no such model
 */
async function knownModel(model: string | undefined): Promise<Model> {
	if (model !== undefined && !isModel(model)) throw modelUnknown(model);
	return modelNamed(model);
}
