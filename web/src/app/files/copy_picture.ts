import { withLink } from "../../formats/png_link";
import { linkOf } from "../address";
import type { Studio } from "../studio";
import { plantToSave } from "./plant_to_save";

const TOPIC = "picture";
const INSTEAD = "Download, Picture gives it as a file.";

/** Copies the 3-D view's picture to the clipboard, and notifies of the result. */
export async function copyPicture(studio: Studio): Promise<void> {
	const { picture } = studio.state;
	const refuse = (why: string) => studio.notify("The picture was not copied", [why, INSTEAD], { topic: TOPIC });
	if (!picture) return refuse("There is no 3-D view to take it of.");
	// Without https browsers have no clipboard, and some have none for pictures.
	if (typeof ClipboardItem === "undefined" || !navigator.clipboard?.write)
		return refuse("This browser lets no page copy pictures.");
	const taken = pictureOf(studio, picture);
	try {
		// Pass a promise: some browsers accept a write only during the click's event, and taking the picture takes longer.
		await navigator.clipboard.write([new ClipboardItem({ "image/png": taken })]);
		studio.notify("Picture copied", [], { topic: TOPIC, brief: true });
	} catch {
		const failed = await taken.then(() => undefined).catch((error: unknown) => error);
		refuse(failed instanceof Error ? failed.message : "The browser did not let the page copy.");
	}
}

async function pictureOf(studio: Studio, take: () => Promise<Blob>): Promise<Blob> {
	const { model, from } = await plantToSave(studio);
	return withLink(await take(), await linkOf(model, from));
}
