/** Summary of a bunch in words: for the caption, the picture's description and screen readers. */
import type { BunchPlant } from "./bunch_plant";
import { metresPerPixel } from "./profile/handles";
import type { BunchSpecimen } from "./specimen";

/** Age in percent from which on there are berries. */
export const FRUIT_SET = 10;

/** Returns a length in words: "22 cm", "4.2 cm". */
export function lengthInWords(metres: number): string {
	const centimetres = metres * 100;
	return `${centimetres < 10 ? Math.round(centimetres * 10) / 10 : Math.round(centimetres)} cm`;
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

/** Returns "73 berries, 22 cm long"; before they set, "73 flowers". */
export function bunchInWords(grown: BunchPlant, specimen: BunchSpecimen): string {
	const { procedure, counts } = grown;
	const { berries } = counts;
	const inFlower = procedure === "natural" && specimen.parameters.age < FRUIT_SET;
	const [one, many] = inFlower ? ["flower", "flowers"] : ["berry", "berries"];
	return `${berries} ${berries === 1 ? one : many}, ${lengthInWords(bunchLength(grown, specimen))} long`;
}

/** Summarises the stems alone: "120 pedicels, 34 withered". In natural bunches nothing withers. */
export function stemsInWords({ procedure, counts: { pedicels, withered } }: BunchPlant): string {
	return procedure === "paper" ? `${pedicels} pedicels, ${withered} withered` : `${pedicels} pedicels`;
}
