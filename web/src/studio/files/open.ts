import { modelNamed } from "../../models/index";
import { modelIn, restore } from "../../specimen/restore";
import type { Studio } from "../studio";
import { TRY_AGAIN } from "../types";

/** Brings back the specimen of a GLB or JSON, of whatever model; whatever is wrong with the file is said, and the plant stays. */
export async function openFile(studio: Studio, file: File): Promise<void> {
	const reader = await import("../../export/restore").catch(() => undefined);
	if (!reader) {
		const again = () => void openFile(studio, file);
		studio.notify("The file was not opened", ["Part of the page could not be fetched.", TRY_AGAIN], { again });
		return;
	}
	try {
		const record = await reader.recordInFile(file.name, file);
		const model = await modelNamed(modelIn(record));
		studio.take(model, restore(model, record), "file");
	} catch (error) {
		const reason =
			error instanceof reader.FileError ? error.message : `${file.name} could not be read; try to drop it again.`;
		studio.notify("The file was not opened", [reason]);
	}
}

/** The files that the picker offers. */
export const ACCEPT = ".glb,.json,model/gltf-binary,application/json";
