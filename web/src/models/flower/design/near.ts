/** Maps presets whose text is no design to the most similar designed preset, by symmetry, whorls and stamens. */

const NEAREST: Readonly<Record<string, readonly string[]>> = {
	"designed-buttercup": ["buttercup", "globeflower", "poppy", "rose", "water-lily"],
	"designed-lily": ["lily", "bluebell", "crocus", "raceme", "umbel"],
	"designed-violet": ["pansy", "spike"],
};

/** Returns the name of the most similar designed preset; the thesis's own example if none is similar. */
export function designedNear(preset: string): string {
	return Object.keys(NEAREST).find((designed) => NEAREST[designed].includes(preset)) ?? "designed-tulip";
}
