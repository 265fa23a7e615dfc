/** What the page and the worker that makes files say to each other: one request, one answer. */
import type { FileOptions } from "../../formats/plant_files";
import type { Plant } from "../../plant/plant";
import type { Specimen } from "../../specimen/specimen";

/** A file that is wanted. All of it is plain data. */
export interface FileRequest {
	/** The model's name. */
	readonly model: string;
	/** The key of a file of every plant (formats/plant_files.ts), `obj`, `json`, or the key of one of the model's formats. */
	readonly format: string;
	readonly grown: Plant;
	/** What it grew from, with the look that the file is to have. */
	readonly specimen: Specimen;
	/** The whole address that brings it back. */
	readonly link: string;
	/** What the file is called, without extension. */
	readonly name: string;
	readonly options?: FileOptions;
	/** Where the model's core lies, for files that show the plant at many ages or for many distances. */
	readonly core?: string;
}

export type FromExporter =
	/** A blob goes from thread to thread without being copied. */
	| { readonly type: "made"; readonly file: Blob }
	/** The page has brought this model by itself, and the worker knows nothing of it. */
	| { readonly type: "unknown" }
	/** The model's script did not come. */
	| { readonly type: "unfetched" }
	| { readonly type: "failed"; readonly message: string };
