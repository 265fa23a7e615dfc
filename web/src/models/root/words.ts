/** Describes a root in a few words, for captions, descriptions of pictures and screen readers. */
import { countInWords, heightsOf, lengthInWords } from "../../plant/in_words";
import type { TrailPlant } from "../particles/trails";

/** "1.4 m deep, 1,800 root tips". */
export function rootInWords({ segments, counts }: TrailPlant): string {
	const { low } = heightsOf(segments.ends);
	return `${lengthInWords(Math.max(0, -low))} deep, ${countInWords(counts.particles ?? 0, "root tip", "root tips")}`;
}
