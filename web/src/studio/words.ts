/** The bunch in a few plain words: for the caption, the picture's description and the screen reader. */
import type { Grown } from "../core/grown";
import { metresPerPixel } from "../profile/handles";
import type { Specimen } from "../specimen/specimen";
import { FRUIT_SET } from "./age";

/** "22 cm", "4.2 cm". */
export function lengthInWords({ parameters: { l, unit } }: Specimen): string {
	const centimetres = l * metresPerPixel(unit) * 100;
	return `${centimetres < 10 ? Math.round(centimetres * 10) / 10 : Math.round(centimetres)} cm`;
}

/** "73 berries, 22 cm long"; before they set, "73 flowers". */
export function bunchInWords({ procedure, counts: { berries } }: Grown, specimen: Specimen): string {
	const inFlower = procedure === "natural" && specimen.parameters.age < FRUIT_SET;
	const [one, many] = inFlower ? ["flower", "flowers"] : ["berry", "berries"];
	return `${berries} ${berries === 1 ? one : many}, ${lengthInWords(specimen)} long`;
}

/** "120 pedicels, 34 withered": of the stems alone. In a natural bunch nothing withers. */
export function stemsInWords({ procedure, counts: { pedicels, withered } }: Grown): string {
	return procedure === "paper" ? `${pedicels} pedicels, ${withered} withered` : `${pedicels} pedicels`;
}
