/** Plants of wood, with the segment of each vertex of their tubes. */
import type { Plant } from "../plant";

export interface Wooden extends Plant {
	/** The segment of each vertex of the mesh `stems`; absent without meshes. */
	vertexSegments?: Uint32Array;
	/** 1 for each segment of dead wood without bark; absent where there is none. */
	deadSegments?: Uint8Array;
}
