/** What the page and the worker that reads a mesh's file send to each other: one file, one answer. */
import type { ClosedMesh } from "../../specimen/closed_mesh";

export type FromMeshReader =
	| { readonly type: "read"; readonly mesh: ClosedMesh }
	/** The file holds no mesh that can be a boundary; the message says why. */
	| { readonly type: "failed"; readonly message: string };
