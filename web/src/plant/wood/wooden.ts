/** Plants of wood: of each vertex of their tubes it is known which segment it goes around. */
import type { Plant } from "../plant";

export interface Wooden extends Plant {
	/** By vertex of the mesh `stems`; absent without meshes. */
	bearing?: Uint32Array;
}
