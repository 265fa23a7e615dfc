/** Describes a root in a few words, for captions, descriptions of pictures and screen readers. */

import { heightsOf, lengthInWords } from "../../plant/in_words";
import type { TrailPlant } from "../particles/trails";
import { text } from "./messages.generated";

/** Describes a root: "1.4 m deep, 1,800 root tips". */
export function rootInWords({ segments, counts }: TrailPlant): string {
	const { low } = heightsOf(segments.ends);
	return text("summary", { depth: lengthInWords(Math.max(0, -low)), tips: counts.particles ?? 0 });
}
