/** The core's exports and the sections of its results, by the names and numbers of boundary/panicle.h. */

type Pointer = number;

export interface CoreExports {
	memory: WebAssembly.Memory;
	_initialize?(): void;
	panicle_abi(): number;
	panicle_allocate(bytes: number): Pointer;
	panicle_release(memory: Pointer): void;
	panicle_grow(request: Pointer, bytes: number): Pointer;
	panicle_section(result: Pointer, section: number): Pointer;
	panicle_section_bytes(result: Pointer, section: number): number;
	panicle_free(result: Pointer): void;
}

/** Version of the layout that this side speaks. */
export const ABI = 2;

export const SECTION = {
	status: 0,
	message: 1,
	notes: 2,
	plan: 3,
	second: 4,
	counts: 5,
	internodes: 6,
	internodeEnds: 7,
	internodeRadii: 8,
	berries: 9,
	berryDirections: 10,
	berryParents: 11,
	fingerprints: 12,
	stemPositions: 13,
	stemNormals: 14,
	stemUvs: 15,
	stemIndices: 16,
	stemInternodes: 17,
	stemParts: 18,
	berryPositions: 19,
	berryNormals: 20,
	berryUvs: 21,
	berryIndices: 22,
	procedure: 23,
	berryIds: 24,
	berryTraits: 25,
	thinned: 26,
	measures: 27,
	surfacePositions: 28,
	surfaceNormals: 29,
	surfaceUvs: 30,
	surfaceIndices: 31,
	surfacePressed: 32,
	flowerPositions: 33,
	flowerNormals: 34,
	flowerUvs: 35,
	flowerIndices: 36,
	foliagePositions: 37,
	foliageNormals: 38,
	foliageUvs: 39,
	foliageIndices: 40,
	foliageParts: 41,
} as const;

const FUNCTIONS = ["abi", "allocate", "release", "grow", "section", "section_bytes", "free"];

/** Whether a module's exports are those of a core. */
export function areCoreExports(exports: object): exports is CoreExports {
	const has = exports as Record<string, unknown>;
	return (
		has.memory instanceof WebAssembly.Memory && FUNCTIONS.every((name) => typeof has[`panicle_${name}`] === "function")
	);
}
