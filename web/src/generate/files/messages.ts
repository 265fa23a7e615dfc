/** Messages between the page and the worker that makes files: one request, one answer. */
import type { FileOptions } from "../../formats/file_options";
import type { Message } from "../../locale/texts";
import type { Plant } from "../../plant/plant";
import type { Specimen } from "../../specimen/specimen";

/** A request for a file: plain data. */
export interface FileRequest {
	/** The model's name. */
	readonly model: string;
	/**
	 * The key of a file of every plant (formats/plant_files.ts), `obj`, `json`, or the key of one of the model's
	 * formats.
	 */
	readonly format: string;
	readonly grown: Plant;
	/** The specimen that the plant grew from, with the look for the file. */
	readonly specimen: Specimen;
	/** The whole address that restores the specimen. */
	readonly link: string;
	/** The name of the file, without extension. */
	readonly name: string;
	readonly options?: FileOptions;
	/** The address of the model's core, for files that show the plant at many ages or levels of detail. */
	readonly core?: string;
}

export type FromExporter =
	/** A blob moves between threads without a copy. */
	| { readonly type: "made"; readonly file: Blob }
	/** The page has added this model; the worker does not know it. */
	| { readonly type: "unknown" }
	/** The model's script could not be fetched. */
	| { readonly type: "unfetched" }
	| { readonly type: "failed"; readonly message: Message };
