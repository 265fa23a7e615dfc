import { html, nothing } from "lit";
import { chooseFile } from "../../../ui/choose_file";
import { isPicture, PICTURES } from "../../../ui/picture_file";
import { FILE_TOPIC } from "../../../ui/tool";
import { text } from "../messages.generated";
import type { Photo } from "../photo/photo";
import type { BunchContext, BunchTool } from "./context";

/**
 * Tool: a photograph behind a flat view, to fit the handles to. It remains in the page: links and files do not contain
 * it, and it is never uploaded.
 */
export const photo: BunchTool<Photo | undefined> = {
	name: "photo",
	initial: undefined,
	panel: { group: "shape", place: "below", draw },
	drop: {
		get description() {
			return text("photo_drop");
		},
		takes: isPicture,
		take: (context, file) => void takePhoto(context, file),
	},
};

/** Loads photo/place_photo.ts and places a photograph. */
async function takePhoto(context: BunchContext, file: Blob): Promise<void> {
	const again = () => void takePhoto(context, file);
	const module = await import("../photo/place_photo").catch(() => undefined);
	if (module) await module.placePhoto(context, file);
	else
		context.notify(text("photo_unusable"), [text("load_failed")], {
			topic: FILE_TOPIC,
			again,
		});
}

/** Changes the photograph; does nothing if it has been removed. */
export function changePhoto(context: BunchContext, change: Partial<Photo>): void {
	const before = context.toolState(photo);
	if (before) context.setToolState(photo, { ...before, ...change });
}

/** Removes the photograph and releases its memory. */
export function removePhoto(context: BunchContext): void {
	context.toolState(photo)?.picture.close();
	context.setToolState(photo, undefined);
}

/** Renders the choice of a photograph and, if one is placed, its controls. */
function draw(context: BunchContext): unknown {
	const placed = context.toolState(photo);
	const caption = placed ? text("photo_replace") : text("photo_add");
	const take = (file: File) => void takePhoto(context, file);
	return html`<div class="actions">
		${chooseFile({ accept: PICTURES, label: text("photo_file"), caption, take })}
		${placed ? html`<panicle-photo-controls class="actions" .context=${context}></panicle-photo-controls>` : nothing}
	</div>`;
}
