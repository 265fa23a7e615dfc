/** Motion of a model's plant in wind, for files that show it. */
import type { Model } from "../../models/model";
import type { Plant } from "../../plant/plant";
import { type Sway, swayOf } from "../../plant/sway";

/** Returns a plant's motion in wind; undefined for plants that wind does not move. */
export const swayed = (model: Pick<Model, "still">, grown: Plant): Sway | undefined =>
	model.still ? undefined : swayOf(grown);
