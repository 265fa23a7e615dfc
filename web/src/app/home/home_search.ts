/** The search of the home page: the presets of all models, loaded with the first search. */
import { modelNamed, modelNames } from "../../models/index";
import type { PageModel } from "../../models/page_model";
import { placeInWords, searchPresets } from "../preset_search";
import { sectionsOf } from "../preset_sections";

/** A plant that matches a search. */
export interface FoundPreset {
	readonly model: string;
	readonly preset: string;
	readonly title: string;
	/** Its family, kind and method, which distinguish plants with equal titles. */
	readonly place: string;
	/** The address of its picture, for the dark theme or the light one; undefined where its model has no pictures. */
	readonly picture: ((dark: boolean) => string) | undefined;
}

/** The most plants that a search lists. */
const MAX_FOUND = 24;

/** Returns the address of a preset's picture. */
const pictureOf = (model: string, preset: string, dark: boolean): string =>
	`${import.meta.env.BASE_URL}gallery/${model}/${preset}-${dark ? "dark" : "light"}.webp`;

let models: readonly PageModel[] = [];

/** Loads the presets of all models; rejects where none can be fetched. */
export async function loadPresets(): Promise<void> {
	if (models.length > 0) return;
	const loaded = await Promise.allSettled(modelNames().map((name) => modelNamed(name)));
	models = loaded.flatMap((model) => (model.status === "fulfilled" ? [model.value] : []));
	if (models.length === 0) throw new Error("No model could be loaded.");
}

/** Returns the plants that match a query, best first; none for an empty query. */
export function findPlants(query: string): readonly FoundPreset[] {
	if (query.trim() === "") return [];
	return searchPresets(sectionsOf(models), query)
		.slice(0, MAX_FOUND)
		.map(({ entry: { model, kind, preset } }) => ({
			model: model.name,
			preset: preset.name,
			title: preset.title,
			place: placeInWords({ model, kind, preset }),
			picture: model.pictures === false ? undefined : (dark: boolean) => pictureOf(model.name, preset.name, dark),
		}));
}
