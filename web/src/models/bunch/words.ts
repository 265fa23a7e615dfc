/** Summary of a bunch in words: for the caption, the picture's description and screen readers. */

import { formatNumber } from "../../locale/format";
import type { BunchPlant } from "./bunch_plant";
import { text } from "./messages.generated";
import { metresPerPixel } from "./profile/handles";
import type { BunchSpecimen } from "./specimen";

/** Age in percent from which on there are berries. */
export const FRUIT_SET = 10;

/** Returns a length in words: "22 cm", "4.2 cm". */
export function lengthInWords(metres: number): string {
	const centimetres = metres * 100;
	return `${formatNumber(centimetres < 10 ? Math.round(centimetres * 10) / 10 : Math.round(centimetres))} cm`;
}

/**
 * Returns the length from the highest berry's top to the lowest one's end; for the paper's bunches, that of the
 * profile.
 */
function bunchLength({ procedure, berries }: BunchPlant, { parameters: { l, unit } }: BunchSpecimen): number {
	if (procedure === "paper" || berries.count === 0) return l * metresPerPixel(unit);
	let top = Number.NEGATIVE_INFINITY;
	let bottom = Number.POSITIVE_INFINITY;
	for (let at = 0; at < 4 * berries.count; at += 4) {
		top = Math.max(top, berries.spheres[at + 1] + berries.spheres[at + 3]);
		bottom = Math.min(bottom, berries.spheres[at + 1] - berries.spheres[at + 3]);
	}
	return top - bottom;
}

/** Returns "22 cm long, with 73 berries"; before they set, "with 73 flowers". */
export function bunchInWords(grown: BunchPlant, specimen: BunchSpecimen): string {
	const { procedure, counts } = grown;
	const inFlower = procedure === "natural" && specimen.parameters.age < FRUIT_SET;
	const args = { count: counts.berries, length: lengthInWords(bunchLength(grown, specimen)) };
	return inFlower ? text("flowers_and_length", args) : text("berries_and_length", args);
}

/** Summarises the stems alone: "120 pedicels, 34 of them withered". In natural bunches nothing withers. */
export function stemsInWords({ procedure, counts: { pedicels, withered } }: BunchPlant): string {
	return procedure === "paper"
		? text("pedicels_withered", { count: pedicels, withered })
		: text("pedicels", { count: pedicels });
}
