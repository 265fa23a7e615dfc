/** The presets of all models by kind, as galleries show them. */
import type { PageModel } from "../models/page_model";
import type { Preset, PresetKind } from "../specimen/presets";

/** The presets of one kind of one model. */
export interface PresetSection {
	readonly model: PageModel;
	readonly kind: PresetKind;
	readonly presets: readonly Preset[];
}

/** Returns the key of a kind of one model, for the gallery's filter. */
export function kindKey({ model, kind }: Pick<PresetSection, "model" | "kind">): string {
	return `${model.name} ${kind.key}`;
}

/** Lists every kind of every model that has presets, in the order of the gallery. */
export function sectionsOf(models: readonly PageModel[]): readonly PresetSection[] {
	const known = sections.get(models);
	if (known) return known;
	const made = models
		.flatMap((model) =>
			model.presets.kinds.map((kind) => ({
				model,
				kind,
				presets: model.presets.list.filter((preset) => preset.kind === kind.key),
			})),
		)
		.filter(({ presets }) => presets.length > 0);
	sections.set(models, made);
	return made;
}

/** Sections by their models, since the gallery lists them with every drawing. */
const sections = new WeakMap<readonly PageModel[], readonly PresetSection[]>();
