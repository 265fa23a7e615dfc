/** The smallest and the largest radius of the paper's berries never cross. */
import type { Detail } from "../../../specimen/species";
import type { BunchSpecimen } from "../specimen";

export const radii: Detail<BunchSpecimen> = {
	keys: [],
	agree: ({ parameters }, notes) => {
		const { rmin, rmax } = parameters;
		if (rmin <= rmax) return;
		notes.add("rmin", `${rmin} is above rmax, ${rmax}`, "the two are swapped");
		parameters.rmin = rmax;
		parameters.rmax = rmin;
	},
	push: (parameters, changed) => {
		if (parameters.rmin <= parameters.rmax) return;
		if (changed.rmin !== undefined) parameters.rmax = parameters.rmin;
		else parameters.rmin = parameters.rmax;
	},
};
