import type { Model } from "../models/model";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";

/** A grown plant with its specimen. */
export interface DescribedPlant {
	readonly model: Model;
	readonly specimen: Specimen;
	readonly grown: Plant;
}

/** Describes a plant for users that cannot see it: "Riesling bunch: 99 berries, 12 cm long", "Oak leaf, 42 cm², …". */
export function plantInWords({ model, specimen, grown }: DescribedPlant): string {
	const words = model.words(grown, specimen);
	// The words of some models already contain the noun.
	if (/^[^,:]*/.exec(words.toLowerCase())?.[0].includes(model.noun)) return words;
	const title = model.titled?.(specimen) ?? model.presets.named(specimen.preset)?.title ?? model.title;
	const named = title.toLowerCase().includes(model.noun) ? title : `${title} ${model.noun}`;
	return `${named}: ${words}`;
}
