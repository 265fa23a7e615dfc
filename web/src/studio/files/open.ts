import type { Studio } from "../studio";

/** Brings back the specimen of a GLB or JSON; whatever is wrong with the file is said, and the bunch stays. */
export async function openFile(studio: Studio, file: File): Promise<void> {
	const { FILE_BYTES, FileError, specimenFromFile } = await import("../../export/restore");
	if (file.size > FILE_BYTES) {
		studio.notify(`${file.name} is too large`, [`Files of Panicle's stay under ${FILE_BYTES / 1024 / 1024} MiB.`]);
		return;
	}
	try {
		studio.take(specimenFromFile(file.name, new Uint8Array(await file.arrayBuffer())), "file");
	} catch (error) {
		const reason = error instanceof FileError ? error.message : `${file.name} could not be read; try to drop it again.`;
		studio.notify("The file was not opened", [reason]);
	}
}

/** The files that the picker offers. */
export const ACCEPT = ".glb,.json,model/gltf-binary,application/json";
