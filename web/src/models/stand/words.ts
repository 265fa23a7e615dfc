/** Describes a stand in a few words, for captions, descriptions of pictures and screen readers. */
import { text } from "./messages.generated";
import type { StandPlant } from "./stand_plant";

/** Describes a stand: "2,000 plants of 4 kinds on 150 × 150 m"; attached plants are counted separately. */
export function standInWords({ counts, ground, members, places }: StandPlant): string {
	const grown = members.filter(Boolean).length;
	const attached = places.parent.reduce((sum, parent) => sum + Number(parent >= 0), 0);
	const count = counts.plants - attached;
	const args = {
		plants: attached === 0 ? text("plants", { count }) : text("plants_attached", { count, attached }),
		kinds: counts.kinds,
		width: roundedLength(ground.width),
		depth: roundedLength(ground.depth),
	};
	return members.length > 0 && grown < members.length
		? text("summary_growing", { ...args, grown })
		: text("summary", args);
}

/** Rounds a length in metres to decimetres. */
const roundedLength = (length: number): number => Math.round(10 * length) / 10;
