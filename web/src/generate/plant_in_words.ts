import type { Model } from "../models/model";
import type { Plant } from "../plant/plant";
import type { Specimen } from "../specimen/specimen";
import { text } from "./messages.generated";

/** A grown plant with its specimen. */
export interface DescribedPlant {
	readonly model: Model;
	readonly specimen: Specimen;
	readonly grown: Plant;
}

/** Describes a plant for users that cannot see it: "Riesling bunch: 12 cm long, with 99 berries", "Oak leaf, 42 cm², …". */
export function plantInWords({ model, specimen, grown }: DescribedPlant): string {
	const description = model.summary(grown, specimen);
	const { plantName: plant } = model;
	// The summaries of some models already contain the plant's name.
	if (/^[^,:]*/.exec(description.toLowerCase())?.[0].includes(plant)) return description;
	const title = model.titled?.(specimen) ?? model.presets.named(specimen.preset)?.title ?? model.title;
	if (title.toLowerCase().includes(plant)) return text("plant_titled", { title, description });
	return text("plant_with_name", { title, plant, description });
}
