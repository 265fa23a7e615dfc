/** A tree in a few plain words: for the caption, the picture's description and the screen reader. */
import { countInWords, heightsOf, lengthInWords } from "../../plant/in_words";
import type { TrailPlant } from "../particles/trails";

/** "9.2 m tall, 5,400 leaves". */
export function treeInWords({ segments, organs, counts }: TrailPlant): string {
	const { high } = heightsOf(segments.ends);
	const leaves = counts.leaves ?? organs.count;
	return `${lengthInWords(Math.max(0, high))} tall, ${leaves === 0 ? "bare" : countInWords(leaves, "leaf", "leaves")}`;
}
