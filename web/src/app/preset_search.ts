/** Searches presets by words and by kind. */
import type { PageModel } from "../models/page_model";
import type { Preset, PresetKind } from "../specimen/presets";

/** The presets of one kind of one model. */
export interface PresetSection {
	readonly model: PageModel;
	readonly kind: PresetKind;
	readonly presets: readonly Preset[];
}

/** Key of a kind of one model, for the gallery's filter. */
export function kindKey({ model, kind }: Pick<PresetSection, "model" | "kind">): string {
	return `${model.name} ${kind.key}`;
}

/** Every kind of every model that has presets, in the order of the gallery. */
export function sectionsOf(models: readonly PageModel[]): readonly PresetSection[] {
	return models
		.flatMap((model) =>
			model.presets.kinds.map((kind) => ({
				model,
				kind,
				presets: model.presets.list.filter((preset) => preset.kind === kind.key),
			})),
		)
		.filter(({ presets }) => presets.length > 0);
}

/**
 * The sections and presets that match a search.
 * @param query words in any order; each must occur in a preset's title, name or description
 * @param kind the key of one kind; all where empty
 */
export function findPresets(sections: readonly PresetSection[], query: string, kind = ""): readonly PresetSection[] {
	const words = wordsOf(query);
	return sections
		.filter((section) => kind === "" || kindKey(section) === kind)
		.map((section) => ({
			...section,
			presets: section.presets.filter((preset) => isIn(words, numberGroupsOf(section, preset))),
		}))
		.filter(({ presets }) => presets.length > 0);
}

function numberGroupsOf({ model, kind }: PresetSection, { name, title, about, figure = "" }: Preset): string {
	return [title, name, about, kind.title, model.title, figure].join(" ");
}

/** The words of a query, without case and accents. */
export const wordsOf = (query: string): string[] => plain(query).split(/\s+/).filter(Boolean);

/** Whether a text contains each of the words. */
export function isIn(words: readonly string[], text: string): boolean {
	const simplified = plain(text);
	return words.every((word) => simplified.includes(word));
}

/** The text without case and accents, which people do not type. */
function plain(text: string): string {
	return text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();
}
