/** Plants of wood, with the segment of each vertex of their tubes. */
import type { Plant } from "../plant";

export interface Wooden extends Plant {
	/** The segment of each vertex of the mesh `stems`; absent without meshes. */
	vertexSegments?: Uint32Array;
}
