import type { Studio } from "../studio";

/** Brings back the specimen of a GLB or JSON; whatever is wrong with the file is said, and the bunch stays. */
export async function openFile(studio: Studio, file: File): Promise<void> {
	const { FileError, specimenFromFile } = await import("../../export/restore");
	try {
		studio.take(await specimenFromFile(file.name, file), "file");
	} catch (error) {
		const reason = error instanceof FileError ? error.message : `${file.name} could not be read; try to drop it again.`;
		studio.notify("The file was not opened", [reason]);
	}
}

/** The files that the picker offers. */
export const ACCEPT = ".glb,.json,model/gltf-binary,application/json";
