/** Summary of a tree in words: for the caption, the picture's description and screen readers. */
import { countInWords, heightsOf, lengthInWords } from "../../plant/in_words";
import type { GrowthPlant } from "./growth_plant";
import type { GrowthSpecimen } from "./specimen";

/** Returns "9.7 m tall, 230 branches, 2,100 leaves, 400 on the ground, among neighbours". */
export function growthInWords({ segments, counts }: GrowthPlant, { surroundings }: GrowthSpecimen): string {
	const { high } = heightsOf(segments.ends);
	const parts = [
		`${lengthInWords(Math.max(0, high))} tall`,
		countInWords(counts.branches, "branch", "branches"),
		counts.leaves === 0 ? "bare" : countInWords(counts.leaves, "leaf", "leaves"),
	];
	if (counts.shed > 0) parts.push(`${countInWords(counts.shed, "leaf", "leaves")} on the ground`);
	if (counts.blossoms > 0) parts.push(countInWords(counts.blossoms, "blossom", "blossoms"));
	if (surroundings) parts.push("among neighbours");
	return parts.join(", ");
}
