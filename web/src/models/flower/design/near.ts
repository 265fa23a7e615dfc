/** Which of the flowers that are designed by choices is nearest to one whose text is no design: by its symmetry, its whorls and its stamens. */

const NEAREST: Readonly<Record<string, readonly string[]>> = {
	"designed-buttercup": ["buttercup", "globeflower", "poppy", "rose", "water-lily"],
	"designed-lily": ["lily", "bluebell", "crocus", "raceme", "umbel"],
	"designed-violet": ["pansy", "spike"],
};

/** @returns a preset's name; of flowers that are like none of them the thesis's own example */
export function designedNear(preset: string): string {
	return Object.keys(NEAREST).find((designed) => NEAREST[designed].includes(preset)) ?? "designed-tulip";
}
