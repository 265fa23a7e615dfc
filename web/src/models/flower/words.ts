/** Summary of a flower in words: for the caption, the picture's description and screen readers. */

import { heightsOf, lengthInWords } from "../../plant/in_words";
import type { FlowerPlant } from "./flower_plant";
import { text } from "./messages.generated";
import { FLOWER_TABLE } from "./table";

const HEIGHT = FLOWER_TABLE.measures.findIndex(({ key }) => key === "height");

/** Returns "42 cm tall, 17 organs, 1,120 volumes". */
export function flowerInWords(plant: FlowerPlant): string {
	const { counts } = plant;
	const parts = [text("height", { length: lengthInWords(heightOf(plant)) })];
	if (counts.organs > 0) parts.push(text("organs", { count: counts.organs }));
	parts.push(text("volumes", { count: counts.volumes }));
	return parts.join(", ");
}

/**
 * Returns the height in metres as measured, from the lowest to the highest point; in previews, of the drawn meshes,
 * else of the stems.
 */
function heightOf({ measures, meshes, segments }: FlowerPlant): number {
	if (measures) return measures[HEIGHT] / 100;
	const drawn = meshes.map(({ positions }) => heightsOf(positions));
	const all = drawn.length > 0 ? drawn : [heightsOf(segments.ends)];
	const [low, high] = [Math.min(...all.map((each) => each.low)), Math.max(...all.map((each) => each.high))];
	return drawn.length > 0 ? high - low : Math.max(0, high);
}
