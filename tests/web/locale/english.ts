/** Every English text that a translation holds, by room and key: catalogues of page and core, tables and presets. */

import {
	coreCatalogues,
	coreRoomCode,
	pageCatalogues,
	pageRoomCode,
} from "../../../wasm-core/tools/generate/messages.mjs";
import { modelNamed, modelNames } from "../../../web/src/models/index";
import type { PageModel } from "../../../web/src/models/page_model";

/** Texts by room and key. */
export type TextsByRoom = Record<string, Record<string, string>>;

/** The English texts, in the order of code: page, core, models. */
export async function englishTexts(): Promise<TextsByRoom> {
	const rooms: TextsByRoom = {};
	for (const { room, messages } of pageCatalogues()) rooms[pageRoomCode(room)] = messages;
	for (const { room, messages } of coreCatalogues()) rooms[coreRoomCode(room)] = messages;
	for (const name of modelNames()) Object.assign(rooms, textsOfModel(await modelNamed(name)));
	return rooms;
}

function textsOfModel({ name, table, presets, descriptors = [] }: PageModel): TextsByRoom {
	const parameters: Record<string, string> = {};
	for (const { key, title, help } of table.groups) {
		parameters[`group_${key}_title`] = title;
		if (help) parameters[`group_${key}_help`] = help;
	}
	for (const entry of table.entries) {
		parameters[`${entry.key}_label`] = entry.label;
		parameters[`${entry.key}_help`] = entry.help;
		if (entry.kind === "choice")
			for (const [i, option] of entry.options.entries())
				parameters[`${entry.key}_option_${option}`] = entry.labels?.[i] ?? option;
		else if (entry.kind !== "colour" && entry.zero) parameters[`${entry.key}_zero`] = entry.zero;
	}
	const measures: Record<string, string> = {};
	for (const { key, title } of table.measureGroups) measures[`group_${key}_title`] = title;
	for (const measure of [...table.measures, ...descriptors]) {
		measures[`${measure.key}_label`] = measure.label;
		const { help, classes = [] } = measure as { help?: string; classes?: readonly { note: number; words: string }[] };
		if (help) measures[`${measure.key}_help`] = help;
		for (const { note, words } of classes) measures[`${measure.key}_class_${note}`] = words;
	}
	const listed: Record<string, string> = {};
	for (const { key, title } of presets.kinds) listed[`kind_${key}_title`] = title;
	for (const preset of presets.list) {
		listed[`${preset.name}_title`] = preset.title;
		listed[`${preset.name}_about`] = preset.about;
	}
	return { [`parameters.${name}`]: parameters, [`measures.${name}`]: measures, [`presets.${name}`]: listed };
}
