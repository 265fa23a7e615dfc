/** Finding presets by words and by kind. */
import type { PageModel } from "../models/page_model";
import type { Preset, PresetKind } from "../specimen/presets";

/** The presets of one kind of one model. */
export interface PresetSection {
	readonly model: PageModel;
	readonly kind: PresetKind;
	readonly presets: readonly Preset[];
}

/** A kind of one model, as a filter names it. */
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
 * What of the sections a search finds.
 * @param query words in any order, each to be found somewhere in what a preset is called or said to be
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

/** What is looked for, word by word. */
export const wordsOf = (query: string): string[] => plain(query).split(/\s+/).filter(Boolean);

/** Whether each of the words is somewhere in a text. */
export function isIn(words: readonly string[], text: string): boolean {
	const said = plain(text);
	return words.every((word) => said.includes(word));
}

/** Without case and accents: people do not type them. */
function plain(text: string): string {
	return text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();
}
