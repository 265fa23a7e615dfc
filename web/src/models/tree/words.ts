/** Describes a tree in a few words, for captions, descriptions of pictures and screen readers. */

import { heightsOf, lengthInWords } from "../../plant/in_words";
import type { TrailPlant } from "../particles/trails";
import { text } from "./messages.generated";

/** Describes a tree: "9.2 m tall, 5,400 leaves". */
export function treeInWords({ segments, organs, counts }: TrailPlant): string {
	const { high } = heightsOf(segments.ends);
	const leaves = counts.leaves ?? organs.count;
	return text("summary", { height: lengthInWords(Math.max(0, high)), leaves });
}
