/** What points on a bunch say of the part that they lie on. */
import type { PointLabels } from "../../../formats/about";

const BERRY = /^Berry (\d+)$/;

export const BUNCH_LABELS: PointLabels = {
	// The numbers stay what they are: a further kind goes to the end.
	classes: [
		...["Rachis", "Axis", "Berry", "Flower", "Cap", "Pistil", "Petals", "Calyx"],
		...["Cane", "Leaf", "Petiole"],
	],
	id: {
		property: "berry_id",
		// The paper's berries have no id but their place in the JSON document, which their names count from 1.
		of: ({ name, extras }) => {
			const [, number] = BERRY.exec(name) ?? [];
			if (number === undefined) return undefined;
			return typeof extras?.id === "number" ? extras.id : Number(number) - 1;
		},
	},
};
