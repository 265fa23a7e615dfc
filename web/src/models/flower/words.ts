/** A flower in a few plain words: for the caption, the picture's description and the screen reader. */
import { countInWords, heightsOf, lengthInWords } from "../../plant/in_words";
import type { FlowerPlant } from "./flower_plant";

/** "42 cm tall, 17 organs, 1,120 volumes". */
export function flowerInWords({ segments, counts }: FlowerPlant): string {
	const { high } = heightsOf(segments.ends);
	const parts = [`${lengthInWords(Math.max(0, high))} tall`];
	if (counts.organs > 0) parts.push(countInWords(counts.organs, "organ", "organs"));
	parts.push(countInWords(counts.volumes, "volume", "volumes"));
	return parts.join(", ");
}
