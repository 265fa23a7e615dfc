/**
 * Loads the function that builds the soil of a stand with the first stand, so that pages without stands do not load
 * it.
 */
type BuildSoil = typeof import("./soil").soilOf;

let buildSoil: BuildSoil | undefined;

/** Loads the function; undefined where it is loaded. */
export function fetchSoil(): Promise<void> | undefined {
	if (buildSoil) return undefined;
	return import("./soil").then(({ soilOf }) => {
		buildSoil = soilOf;
	});
}

export const fetchedSoil = (): BuildSoil | undefined => buildSoil;
