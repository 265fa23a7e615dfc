/** The families of plants as pages present them. */
import type { Family } from "../../specimen/presets";
import { text } from "./messages.generated";

/** The texts and the plant with which a page presents a family. */
export interface FamilyInfo {
	readonly key: Family;
	/** "Trees". */
	readonly title: string;
	/** A line that names some of its plants. */
	readonly about: string;
	/** The plant that the family opens with. */
	readonly model: string;
	readonly preset: string;
}

/** The plant that each family opens with. */
const FIRST: Readonly<Record<Family, { readonly model: string; readonly preset: string }>> = {
	grapes: { model: "bunch", preset: "pinot-noir" },
	trees: { model: "growth", preset: "oak" },
	flowers: { model: "flower", preset: "tulip" },
	leaves: { model: "leaf", preset: "grapevine" },
	roots: { model: "root", preset: "tap" },
	gardens: { model: "stand", preset: "vineyard" },
	grammars: { model: "grammar", preset: "plant-c" },
	topiary: { model: "tree", preset: "bonsai" },
};

/** Returns all families, in the order of the home page. */
export function families(): readonly FamilyInfo[] {
	return (Object.keys(FIRST) as Family[]).map((key) => ({
		key,
		title: familyTitle(key),
		about: text(`about_${key}`),
		...FIRST[key],
	}));
}

/** Returns the title of a family: "Gardens and forests". */
export const familyTitle = (key: Family): string => text(`family_${key}`);

/** Returns the plant that a family opens with. */
export const firstOf = (key: Family): { readonly model: string; readonly preset: string } => FIRST[key];

/**
 * Returns the query of a link to a preset; the same as the link that the studio writes, except for the standard preset
 * of a model.
 */
export const queryOf = (model: string, preset: string): string => `?v=2&model=${model}&preset=${preset}`;
