/** What lays soil over a stand's ground, fetched with the first stand: the page that lists all models does without. */
type BuildSoil = typeof import("./soil").soilOf;

let buildSoil: BuildSoil | undefined;

/** Undefined where it is there. */
export function fetchSoil(): Promise<void> | undefined {
	if (buildSoil) return undefined;
	return import("./soil").then(({ soilOf }) => {
		buildSoil = soilOf;
	});
}

export const fetchedSoil = (): BuildSoil | undefined => buildSoil;
