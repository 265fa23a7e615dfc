import { withLink } from "../../formats/png_link";
import { linkOf } from "../address";
import { text } from "../messages.generated";
import type { Studio } from "../studio";
import type { PictureOptions } from "../studio_state";
import { plantToSave } from "./plant_to_save";

/**
 * Copies the 3-D view's picture to the clipboard.
 * @returns the result, in sentences for the user
 */
export async function copyPicture(studio: Studio, options: PictureOptions = {}): Promise<string> {
	const refuse = (reason: string) => text("picture_failed", { reason });
	if (!studio.state.picture) return refuse(text("picture_no_view"));
	// Without https browsers have no clipboard, and some have none for pictures.
	if (typeof ClipboardItem === "undefined" || !navigator.clipboard?.write) return refuse(text("picture_unsupported"));
	const taken = pictureOf(studio, options);
	try {
		// Pass a promise: some browsers accept a write only during the click's event, and taking the picture takes longer.
		await navigator.clipboard.write([new ClipboardItem({ "image/png": taken })]);
		return text("picture_copied");
	} catch {
		const failed = await taken.then(() => undefined).catch((error: unknown) => error);
		return refuse(failed instanceof Error ? failed.message : text("picture_blocked"));
	}
}

/** Takes a picture of the 3-D view, with the plant's link in its file. @throws Error where there is no 3-D view */
export async function pictureOf(studio: Studio, options: PictureOptions): Promise<Blob> {
	const { picture } = studio.state;
	if (!picture) throw new Error(text("picture_no_view"));
	const { model, from } = await plantToSave(studio);
	return withLink(await picture(options), await linkOf(model, from));
}
