/** Messages between the page and the worker that reads a mesh file: one file, one result. */
import type { Message } from "../../locale/texts";
import type { ClosedMesh } from "../../specimen/closed_mesh";

export type FromMeshReader =
	| { readonly type: "read"; readonly mesh: ClosedMesh }
	/** The file holds no mesh that can be a boundary; `message` gives the reason. */
	| { readonly type: "failed"; readonly message: Message };
