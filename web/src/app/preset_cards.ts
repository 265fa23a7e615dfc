/** The presets of the gallery as cards: pictures, titles, and which family and section each belongs to. */
import { html, nothing, type TemplateResult } from "lit";
import type { PageModel } from "../models/page_model";
import type { Family, Preset, PresetKind } from "../specimen/presets";
import type { Specimen } from "../specimen/specimen";
import { firstOf } from "./home/families";
import { text } from "./messages.generated";
import type { PresetSection } from "./preset_sections";

/** Returns the address of a preset's picture, rendered by the app for each theme (`npm run pictures -- gallery`). */
export const pictureOf = (model: PageModel, { name }: Preset, dark: boolean) =>
	`${import.meta.env.BASE_URL}gallery/${model.name}/${name}-${dark ? "dark" : "light"}.webp`;

/**
 * Renders the picture, the title and the figure number of a preset, inside a button.
 * @param place where it belongs, with its figure, in lists of several families
 */
export function cardContent(model: PageModel, preset: Preset, dark: boolean, place?: string): TemplateResult {
	return html`${
		model.pictures === false
			? html`<span class="no-picture"></span>`
			: html`<img src=${pictureOf(model, preset, dark)} alt="" width="60" height="75" loading="lazy" fetchpriority="low" decoding="async">`
	}${preset.title}${
		place === undefined && preset.figure !== undefined
			? html` <small aria-hidden="true">${text("gallery_figure", { figure: preset.figure })}</small>`
			: nothing
	}${place === undefined ? nothing : html` <small>${place}</small>`}`;
}

/** Returns the description of a preset, with the number of its figure. */
export function described({ about, figure }: Preset): string {
	return figure === undefined ? about : text("gallery_about_figure", { about, figure });
}

/**
 * Returns the kind of the preset that a specimen started from; that of the model's first preset where the preset is
 * unknown.
 */
export function kindOf(model: PageModel, { preset }: Pick<Specimen, "preset">): PresetKind {
	const { list, kinds, named } = { ...model.presets, named: model.presets.named(preset) };
	const key = (named ?? list[0]).kind;
	return kinds.find((kind) => kind.key === key) ?? kinds[0];
}

/** Returns the family of a specimen. */
export const familyOf = (model: PageModel, specimen: Pick<Specimen, "preset">): Family =>
	kindOf(model, specimen).family;

/**
 * Returns the sections of one family: first those of the model that the family opens with, then in the order of the
 * models.
 */
export function sectionsOfFamily(sections: readonly PresetSection[], family: Family): readonly PresetSection[] {
	const first = firstOf(family).model;
	const own = sections.filter(({ kind }) => kind.family === family);
	return [...own.filter(({ model }) => model.name === first), ...own.filter(({ model }) => model.name !== first)];
}

/** Returns the models that have sections, each once. */
export const modelsOf = (sections: readonly PresetSection[]): readonly PageModel[] => [
	...new Set(sections.map(({ model }) => model)),
];

/** Returns the key of a preset among those of all models: "growth/oak". */
export const presetKey = (model: Pick<PageModel, "name">, { name }: Pick<Preset, "name">): string =>
	`${model.name}/${name}`;
