/** Searches the presets of all models: by title, then by family and shelf, then by description. */
import type { PageModel } from "../models/page_model";
import { FAMILIES, type Preset, type PresetKind } from "../specimen/presets";
import { familyTitle, firstOf } from "./home/families";
import { text } from "./messages.generated";
import type { PresetSection } from "./preset_sections";
import synonyms from "./search/synonyms.json";
import { type Scored, type SearchTexts, TextIndex } from "./search/text_index";

/** A preset with its model and its kind. */
export interface PlacedPreset {
	readonly model: PageModel;
	readonly kind: PresetKind;
	readonly preset: Preset;
}

/**
 * Returns where a preset belongs: "Trees · Species · Growth grammars", its family, its kind and its method, if several
 * models grow plants of the family; then the figure of a publication. Presets with equal titles differ in it.
 */
export function placeInWords({ model, kind, preset: { figure } }: PlacedPreset): string {
	const family = familyTitle(kind.family);
	const parts = [family, kind.title, model.shelf ?? family];
	return [...new Set(parts), ...(figure === undefined ? [] : [text("gallery_figure", { figure })])].join(" · ");
}

/**
 * Returns the presets that match a search, best first, with their scores; all for a query without words.
 * @param query words in any order (search/text_index.ts)
 * @param forgives whether words may have a typo if nothing matches otherwise
 */
export function searchPresets(
	all: readonly PresetSection[],
	query: string,
	forgives = true,
): readonly Scored<PlacedPreset>[] {
	return indexFor(all).search(query, forgives);
}

/** The indices used last, newest first: a gallery searches parts of its sections, too. */
let indices: readonly { readonly all: readonly PresetSection[]; readonly index: TextIndex<PlacedPreset> }[] = [];
const MAX_INDICES = 4;

/** Returns the index of sections, created once for the same presets. */
function indexFor(all: readonly PresetSection[]): TextIndex<PlacedPreset> {
	const isSame = (other: readonly PresetSection[]) =>
		other.length === all.length && other.every(({ presets }, i) => presets === all[i].presets);
	const known = indices.find((each) => isSame(each.all)) ?? { all, index: createIndex(all) };
	indices = [known, ...indices.filter((each) => each !== known)].slice(0, MAX_INDICES);
	return known.index;
}

/** Creates the index of sections. */
function createIndex(all: readonly PresetSection[]): TextIndex<PlacedPreset> {
	const placed = all.flatMap(({ model, kind, presets }) => presets.map((preset) => ({ model, kind, preset })));
	// Equally good matches: by family, the plant that it opens with first and those of publications last.
	placed.sort((a, b) => orderOf(a) - orderOf(b));
	return new TextIndex(placed, textsOf, synonyms);
}

/**
 * Returns the position of a preset among equally good matches: by family, then the plant that it opens with, then
 * others, then those of publications.
 */
function orderOf({ model, kind, preset }: PlacedPreset): number {
	const first = firstOf(kind.family);
	const isFirst = first.model === model.name && first.preset === preset.name;
	return 3 * FAMILIES.indexOf(kind.family) + (isFirst ? 0 : preset.figure === undefined ? 1 : 2);
}

/** Puts reproductions of a publication after the plants of a shelf, unless the query is their title. */
const PAPER_PENALTY = 11;

/** Returns the searchable texts of a preset. English keys are among them, so that synonyms work in every language. */
function textsOf({ model, kind, preset }: PlacedPreset): SearchTexts {
	const { name, title, about, source = "", figure } = preset;
	const paper = kind.fromPaper || figure !== undefined ? ["paper"] : [];
	return {
		title,
		names: [name, ...(figure === undefined ? [] : [`figure ${figure}`])],
		shelves: [
			familyTitle(kind.family),
			kind.family,
			kind.title,
			kind.key,
			model.title,
			model.shelf ?? "",
			model.name,
			...paper,
		],
		keys: [`family:${kind.family}`, `model:${model.name}`],
		descriptions: [about, source],
		penalty: kind.fromPaper ? PAPER_PENALTY : 0,
	};
}
