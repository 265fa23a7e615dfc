/**
 * Parameter tables, measures and presets in the language in use. They are built when a model is loaded, after the
 * language. A translation has their texts in the rooms "parameters.<model>", "measures.<model>" and "presets.<model>".
 */
import { translated } from "../locale/locale";
import type { MeasureGroup, MeasureInfo } from "./measures";
import { type Preset, type PresetKind, Presets } from "./presets";
import { type Group, type ParameterEntry, Table } from "./table";

type Translate = (key: string, english: string) => string;

const translateIn =
	(room: string): Translate =>
	(key, english) =>
		translated(`${room}.${key}`, english);

/** Returns the name of an option for people: "Natural"; links write it in lower case with underscores. */
export const optionInWords = (option: string): string =>
	option.charAt(0).toUpperCase() + option.slice(1).replaceAll("_", " ");

/** Returns the table of a model with translated texts. */
export function translatedTable(
	model: string,
	entries: readonly ParameterEntry[],
	groups: readonly Group[],
	measures: readonly MeasureInfo[],
	measureGroups: readonly MeasureGroup[],
): Table {
	const parameter = translateIn(`parameters.${model}`);
	const measure = translateIn(`measures.${model}`);
	return new Table(
		entries.map((entry) => translatedEntry(parameter, entry)),
		groups.map((group) => ({
			...group,
			title: parameter(`group_${group.key}_title`, group.title),
			help: parameter(`group_${group.key}_help`, group.help),
		})),
		measures.map((info) => translatedMeasure(measure, info)),
		measureGroups.map(({ key, title }) => ({ key, title: measure(`group_${key}_title`, title) })),
	);
}

/** A measure, or a descriptor of the look, of a model. */
export const translatedMeasureOf = <M extends Pick<MeasureInfo, "key" | "label" | "help" | "classes">>(
	model: string,
	info: M,
): M => translatedMeasure(translateIn(`measures.${model}`), info);

/** Returns the presets of a model with translated texts. */
export function translatedPresets(
	model: string,
	list: readonly Preset[],
	kinds: readonly PresetKind[],
	standard: string,
): Presets {
	const translate = translateIn(`presets.${model}`);
	return new Presets(
		list.map((preset) => ({
			...preset,
			title: translate(`${preset.name}_title`, preset.title),
			about: translate(`${preset.name}_about`, preset.about),
		})),
		kinds.map((kind) => ({ ...kind, title: translate(`kind_${kind.key}_title`, kind.title) })),
		standard,
	);
}

/** Translates a parameter's label and help, and its options or its word for 0. */
function translatedEntry(translate: Translate, entry: ParameterEntry): ParameterEntry {
	const texts = {
		label: translate(`${entry.key}_label`, entry.label),
		help: translate(`${entry.key}_help`, entry.help),
	};
	if (entry.kind === "choice") {
		const labels = entry.options.map((option) => translate(`${entry.key}_option_${option}`, optionInWords(option)));
		return { ...entry, ...texts, labels };
	}
	if (entry.kind !== "colour" && entry.zero)
		return { ...entry, ...texts, zero: translate(`${entry.key}_zero`, entry.zero) };
	return { ...entry, ...texts };
}

/** Translates a measure's label, help and classes. */
function translatedMeasure<M extends Pick<MeasureInfo, "key" | "label" | "help" | "classes">>(
	translate: Translate,
	info: M,
): M {
	const { key, label, help, classes } = info;
	return {
		...info,
		label: translate(`${key}_label`, label),
		help: translate(`${key}_help`, help),
		...(classes && {
			classes: classes.map((each) => ({ ...each, words: translate(`${key}_class_${each.note}`, each.words) })),
		}),
	};
}
