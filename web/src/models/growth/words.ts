/** Summary of a tree in words: for the caption, the picture's description and screen readers. */

import { heightsOf, lengthInWords } from "../../plant/in_words";
import type { GrowthPlant } from "./growth_plant";
import { text } from "./messages.generated";
import type { GrowthSpecimen } from "./specimen";

/** Returns "9.7 m tall, 230 branches, 2,100 leaves, 400 on the ground, among neighbours". */
export function growthInWords({ segments, counts }: GrowthPlant, { surroundings }: GrowthSpecimen): string {
	const { high } = heightsOf(segments.ends);
	const parts = [
		text("height", { length: lengthInWords(Math.max(0, high)) }),
		text("branches", { count: counts.branches }),
		text("leaves", { count: counts.leaves }),
	];
	if (counts.shed > 0) parts.push(text("fallen_leaves", { count: counts.shed }));
	if (counts.blossoms > 0) parts.push(text("blossoms", { count: counts.blossoms }));
	if (surroundings) parts.push(text("among_neighbours"));
	return parts.join(", ");
}
