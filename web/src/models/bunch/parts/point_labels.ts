/** Labels of points on a bunch: the class and id of their part. */
import type { PointLabels } from "../../../formats/about";

const BERRY = /^Berry (\d+)$/;

export const BUNCH_LABELS: PointLabels = {
	// Class numbers are frozen: append new kinds at the end.
	classes: [
		...["Rachis", "Axis", "Berry", "Flower", "Cap", "Pistil", "Petals", "Calyx"],
		...["Cane", "Leaf", "Petiole"],
	],
	id: {
		property: "berry_id",
		// The paper's berries have no ids; their index in the JSON document is their name's number less 1.
		of: ({ name, extras }) => {
			const [, number] = BERRY.exec(name) ?? [];
			if (number === undefined) return undefined;
			return typeof extras?.id === "number" ? extras.id : Number(number) - 1;
		},
	},
};
