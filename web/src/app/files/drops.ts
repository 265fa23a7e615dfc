/** Takes files that are opened or dropped. The script that opens them is fetched with the first file. */
import { FILE_TOPIC, type ToolDrop } from "../../ui/tool";
import { text } from "../messages.generated";
import { applying } from "../panel_groups";
import type { Studio } from "../studio";
import { fetchFailed } from "../types";

/** Returns the kinds of files that the tools of the specimen take. */
export function dropsOf({ state: { modelUi, specimen } }: Studio): ToolDrop[] {
	return applying(modelUi?.tools, specimen).flatMap(({ drop }) => drop ?? []);
}

/** Opens a file (open.ts). Errors are shown as notices, and the plant stays. */
export async function takeFile(studio: Studio, file: File): Promise<void> {
	const opener = await import("./open").catch(() => undefined);
	if (opener) await opener.openFile(studio, file);
	else {
		studio.notify(text("open_failed"), fetchFailed(), {
			topic: FILE_TOPIC,
			again: () => void takeFile(studio, file),
		});
	}
}
