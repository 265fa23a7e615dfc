/** Describes a stand in a few words, for captions, descriptions of pictures and screen readers. */
import { countInWords } from "../../plant/in_words";
import type { StandPlant } from "./stand_plant";

/** "2,000 plants of 4 kinds on 150 × 150 m"; attached plants are counted separately. */
export function standInWords({ counts, ground, members, places }: StandPlant): string {
	const grown = members.filter(Boolean).length;
	const attached = places.parent.reduce((sum, parent) => sum + Number(parent >= 0), 0);
	const standing = countInWords(counts.plants - attached, "plant", "plants");
	const whole = attached === 0 ? standing : `${standing} and ${attached.toLocaleString("en")} borne,`;
	const kinds = counts.kinds === 1 ? "" : ` of ${counts.kinds} kinds`;
	const rest = members.length > 0 && grown < members.length ? `, ${grown} grown so far` : "";
	return `${whole}${kinds} on ${metres(ground.width)} × ${metres(ground.depth)} m${rest}`;
}

const metres = (length: number): string => String(Math.round(10 * length) / 10);
