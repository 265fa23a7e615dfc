/** The files that the palette offers to download, and the dialogs of the batch export and of the embed code. */
import { text as appText } from "../messages.generated";
import type { DownloadSheet } from "../parts/download_sheet";
import { BATCH, EMBED } from "../parts/file_parts";
import { DOWNLOADS } from "../parts/late_parts";
import { type LatePart, openPart } from "../parts/open_part";
import type { Studio } from "../studio";
import type { PaletteEntry } from "./entries";
import { text } from "./messages.generated";

/** Returns the entries of the formats of the plant in view. Rejects where their script cannot be fetched. */
export async function downloadEntries(studio: Studio): Promise<readonly PaletteEntry[]> {
	const { downloadFormats } = await import("../files/formats");
	const { shown, picture } = studio.state;
	if (!shown) return [];
	return downloadFormats(shown, picture).map(({ key, title, about, suffix }) => ({
		key: `download:${key}`,
		group: "actions",
		title: text("download", { format: title }),
		about,
		icon: "download",
		texts: { title: text("download", { format: title }), names: [title, key, suffix], descriptions: [about] },
		run: () => openPart<DownloadSheet>(studio, DOWNLOADS, (sheet) => sheet.download(key)),
	}));
}

/** Returns the entries of the batch export and the embed code. */
export function fileDialogEntries(studio: Studio): readonly PaletteEntry[] {
	const entry = (key: string, part: LatePart, title: string, about: string): PaletteEntry => ({
		key: `action:${key}`,
		group: "actions",
		title,
		about,
		icon: "download",
		texts: { title, names: [key], descriptions: [about] },
		run: () => openPart(studio, part),
	});
	return [
		entry("batch", BATCH, appText("download_batch"), appText("download_batch_about")),
		entry("embed", EMBED, appText("download_embed"), appText("download_embed_about")),
	];
}
