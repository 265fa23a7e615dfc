/** Describes a tree in a few words, for captions, descriptions of pictures and screen readers. */
import { countInWords, heightsOf, lengthInWords } from "../../plant/in_words";
import type { TrailPlant } from "../particles/trails";

/** "9.2 m tall, 5,400 leaves". */
export function treeInWords({ segments, organs, counts }: TrailPlant): string {
	const { high } = heightsOf(segments.ends);
	const leaves = counts.leaves ?? organs.count;
	return `${lengthInWords(Math.max(0, high))} tall, ${leaves === 0 ? "bare" : countInWords(leaves, "leaf", "leaves")}`;
}
