/** Keeps the smallest radius of the paper's berries at or below the largest. */

import type { Field } from "../../../specimen/model_schema";
import { text } from "../messages.generated";
import type { BunchSpecimen } from "../specimen";

export const radii: Field<BunchSpecimen> = {
	keys: [],
	agree: ({ parameters }, notes) => {
		const { rmin, rmax } = parameters;
		if (rmin <= rmax) return;
		notes.add("rmin", text.message("rmin_above_rmax", { rmin, rmax }), text("radii_swapped"));
		parameters.rmin = rmax;
		parameters.rmax = rmin;
	},
	push: (parameters, changed) => {
		if (parameters.rmin <= parameters.rmax) return;
		if (changed.rmin !== undefined) parameters.rmax = parameters.rmin;
		else parameters.rmin = parameters.rmax;
	},
};
