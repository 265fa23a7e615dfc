/** What lays soil over a stand's ground, fetched with the first stand: the page that lists all models does without. */
type Lay = typeof import("./soil").soilOf;

let lay: Lay | undefined;

/** Undefined where it is there. */
export function fetchSoil(): Promise<void> | undefined {
	if (lay) return undefined;
	return import("./soil").then(({ soilOf }) => {
		lay = soilOf;
	});
}

export const fetchedSoil = (): Lay | undefined => lay;
