/** The bunch in a few plain words: for the caption, the picture's description and the screen reader. */
import type { Grown } from "../core/grown";
import { metresPerPixel } from "../profile/handles";
import type { Specimen } from "../specimen/specimen";

/** "22 cm", "4.2 cm". */
export function lengthInWords({ parameters: { l, unit } }: Specimen): string {
	const centimetres = l * metresPerPixel(unit) * 100;
	return `${centimetres < 10 ? Math.round(centimetres * 10) / 10 : Math.round(centimetres)} cm`;
}

/** "73 berries, 22 cm long". */
export function bunchInWords({ counts: { berries } }: Grown, specimen: Specimen): string {
	return `${berries} ${berries === 1 ? "berry" : "berries"}, ${lengthInWords(specimen)} long`;
}

/** "120 pedicels, 34 withered": of the stems alone. */
export function stemsInWords({ counts: { pedicels, withered } }: Grown): string {
	return `${pedicels} pedicels, ${withered} withered`;
}
