/**
 * Loads the function that builds the soil of a stand with the first stand, so that pages without stands do not load
 * it.
 */
type BuildSoil = typeof import("./soil").soilOf;

let buildSoil: BuildSoil | undefined;

/** Loads the function that builds the soil; returns undefined where it is loaded already. */
export function fetchSoil(): Promise<void> | undefined {
	if (buildSoil) return undefined;
	return import("./soil").then(({ soilOf }) => {
		buildSoil = soilOf;
	});
}

/** Returns the function that builds the soil; undefined before it is loaded. */
export const fetchedSoil = (): BuildSoil | undefined => buildSoil;
