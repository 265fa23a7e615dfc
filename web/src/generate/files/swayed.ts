/** How wind moves a plant of a model, for files that show it. */
import type { Model } from "../../models/model";
import type { Plant } from "../../plant/plant";
import { type Sway, swayOf } from "../../plant/sway";

/** Undefined of what stands still. */
export const swayed = (model: Pick<Model, "still">, grown: Plant): Sway | undefined =>
	model.still ? undefined : swayOf(grown);
