import { FILE_TOPIC, type ToolDrop } from "../../controls/tool";
import { modelNamed } from "../../models/index";
import { modelIn, restore } from "../../specimen/restore";
import { applying } from "../panel_groups";
import type { Studio } from "../studio";
import { TRY_AGAIN } from "../types";

/**
 * Brings back the specimen of a GLB or JSON, of whatever model; a file without one goes to the tool that takes it. Whatever
 * is wrong with the file is said, and the plant stays.
 */
export async function openFile(studio: Studio, file: File): Promise<void> {
	const refuse = (details: readonly string[], again?: () => void) =>
		studio.notify("The file was not opened", details, { topic: FILE_TOPIC, ...(again ? { again } : {}) });
	const reader = await import("../../export/restore").catch(() => undefined);
	if (!reader) {
		refuse(["Part of the page could not be fetched.", TRY_AGAIN], () => void openFile(studio, file));
		return;
	}
	try {
		const record = await reader.recordInFile(file.name, file);
		const model = await modelNamed(modelIn(record));
		studio.take(model, restore(model, record), FILE_TOPIC);
	} catch (error) {
		const known = error instanceof reader.FileError;
		const drop = known ? dropsOf(studio).find(({ takes }) => takes(file)) : undefined;
		if (drop) drop.take(studio, file);
		else refuse([known ? error.message : `${file.name} could not be read; try to drop it again.`]);
	}
}

/** What tools of the model take of files, those that mean nothing to the specimen left out. */
export function dropsOf({ state: { face, specimen } }: Studio): ToolDrop[] {
	return applying(face?.tools, specimen).flatMap(({ drop }) => drop ?? []);
}

/** The files that the picker offers. */
export const ACCEPT = ".glb,.json,model/gltf-binary,application/json";
