/** Places photographs behind flat views. */

import { PictureError, readBitmap } from "../../../ui/read_bitmap";
import { FILE_TOPIC } from "../../../ui/tool";
import { text } from "../messages.generated";
import type { BunchContext } from "../ui/context";
import { photo } from "../ui/photo";
import { fitted } from "./photo";
import "./photo_controls";
import "./photo_view";

/** Longer side of a stored picture, in pixels: as many as a view on a large screen shows. */
const LONGEST = 2000;
const OPACITY = 0.6;

/** Places a picture behind a view, as high as the bunch; reports errors to the user. */
export async function placePhoto(context: BunchContext, file: Blob): Promise<void> {
	try {
		const picture = await readBitmap(file, LONGEST);
		const before = context.toolState(photo);
		const place = fitted(picture, context.state.specimen.parameters.l);
		context.setToolState(photo, { picture, ...place, view: before?.view ?? "front", opacity: OPACITY, loose: true });
		before?.picture.close();
		context.notify(text("photo_placed"), [text("photo_placed_help")], { topic: FILE_TOPIC, brief: true });
	} catch (error) {
		if (!(error instanceof PictureError)) throw error;
		context.notify(text("photo_unusable"), [error.message], { topic: FILE_TOPIC });
	}
}
