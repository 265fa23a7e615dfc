/** The catalogue of models: their presets and parameters, for programs that let users choose. */
import { modelNamed, modelNames } from "./index";
import type { Model } from "./model";

/** A parameter of a model. */
export interface ParameterInfo {
	/** The key for `grow`. */
	readonly key: string;
	/** The label in panels. */
	readonly label: string;
	/** A choice's value is the name of one of its `options`, a colour's six hexadecimal digits. */
	readonly kind: "number" | "integer" | "choice" | "colour";
	/** Of numbers: `mm`, `%`, `°` …; `px` are the paper's pixels; empty where there is none. */
	readonly unit: string;
	/** The value where neither preset nor caller sets one. */
	readonly default: number | string;
	/** Of numbers. */
	readonly min?: number;
	/** Of numbers. */
	readonly max?: number;
	/** Of choices. */
	readonly options?: readonly string[];
	/** One plain sentence. */
	readonly help: string;
}

/** A model with its presets and parameters. */
export interface CatalogueEntry {
	/** The name in links: `bunch`. */
	readonly model: string;
	/** The heading: "Grape bunch". */
	readonly title: string;
	/** Present where the meaning of the model's links is not frozen yet. */
	readonly preview?: true;
	/** Names of presets, in the order of the gallery. */
	readonly presets: readonly string[];
	/** In the order of the model's panel. */
	readonly parameters: readonly ParameterInfo[];
}

/** Returns the parameters of a model, in the order of its panel. */
export function parametersOf({ table }: Pick<Model, "table">): ParameterInfo[] {
	return table.entries.map((entry) => {
		const { key, label, kind, unit, help } = entry;
		const common = { key, label, kind, unit, help };
		if (entry.kind === "colour") return { ...common, default: entry.default };
		if (entry.kind === "choice") return { ...common, default: entry.options[entry.default], options: entry.options };
		return { ...common, default: entry.default, min: entry.min, max: entry.max };
	});
}

/** Returns all models with their presets and parameters; the default model is the first. */
export async function catalogue(): Promise<CatalogueEntry[]> {
	const all = await Promise.all(modelNames().map(modelNamed));
	return all.map((model) => ({
		model: model.name,
		title: model.title,
		...(model.preview ? { preview: true } : {}),
		presets: model.presets.list.map(({ name }) => name),
		parameters: parametersOf(model),
	}));
}
