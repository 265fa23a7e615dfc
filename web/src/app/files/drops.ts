/** Takes files that are opened or dropped. The script that opens them is fetched with the first file. */
import { FILE_TOPIC, type ToolDrop } from "../../ui/tool";
import { applying } from "../panel_groups";
import type { Studio } from "../studio";
import { TRY_AGAIN } from "../types";

/** The kinds of files that the tools of the specimen take. */
export function dropsOf({ state: { modelUi, specimen } }: Studio): ToolDrop[] {
	return applying(modelUi?.tools, specimen).flatMap(({ drop }) => drop ?? []);
}

/** File types that the file picker offers. */
export const ACCEPT = ".glb,.json,.png,.lsys,.gl3,.growth,.stand,.xml,model/gltf-binary,application/json,image/png";

/** Opens a file (open.ts). Errors are shown as notices, and the plant stays. */
export async function takeFile(studio: Studio, file: File): Promise<void> {
	const opener = await import("./open").catch(() => undefined);
	if (opener) await opener.openFile(studio, file);
	else {
		studio.notify("The file was not opened", ["Part of the page could not be fetched.", TRY_AGAIN], {
			topic: FILE_TOPIC,
			again: () => void takeFile(studio, file),
		});
	}
}
