import { modelNamed } from "../../models/index";
import { modelIn, restore } from "../../specimen/restore";
import type { Studio } from "../studio";

/** Brings back the specimen of a GLB or JSON, of whatever model; whatever is wrong with the file is said, and the plant stays. */
export async function openFile(studio: Studio, file: File): Promise<void> {
	const { FileError, recordInFile } = await import("../../export/restore");
	try {
		const record = await recordInFile(file.name, file);
		const model = await modelNamed(modelIn(record));
		studio.take(model, restore(model, record), "file");
	} catch (error) {
		const reason = error instanceof FileError ? error.message : `${file.name} could not be read; try to drop it again.`;
		studio.notify("The file was not opened", [reason]);
	}
}

/** The files that the picker offers. */
export const ACCEPT = ".glb,.json,model/gltf-binary,application/json";
