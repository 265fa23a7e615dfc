import { html, nothing } from "lit";
import { chooseFile } from "../../../ui/choose_file";
import { isPicture, PICTURES } from "../../../ui/picture_file";
import { FILE_TOPIC } from "../../../ui/tool";
import type { Photo } from "../photo/photo";
import type { BunchContext, BunchTool } from "./context";

/** A photograph that lies behind a flat view, to fit the handles to. It is the page's alone: in no link, in no file, sent nowhere. */
export const photo: BunchTool<Photo | undefined> = {
	name: "photo",
	initial: undefined,
	panel: { group: "shape", place: "below", draw },
	drop: {
		words: "a photograph goes behind the front view",
		takes: isPicture,
		take: (desk, file) => void takePhoto(desk, file),
	},
};

/** Fetches what lays it (photo/place_photo.ts), and does. */
async function takePhoto(desk: BunchContext, file: Blob): Promise<void> {
	const again = () => void takePhoto(desk, file);
	const lay = await import("../photo/place_photo").catch(() => undefined);
	if (lay) await lay.placePhoto(desk, file);
	else
		desk.notify("The photograph was not taken", ["Part of the page could not be fetched."], {
			topic: FILE_TOPIC,
			again,
		});
}

/** Changes what there is of it; nothing where it has gone. */
export function changePhoto(desk: BunchContext, change: Partial<Photo>): void {
	const before = desk.toolState(photo);
	if (before) desk.setToolState(photo, { ...before, ...change });
}

export function removePhoto(desk: BunchContext): void {
	desk.toolState(photo)?.picture.close();
	desk.setToolState(photo, undefined);
}

function draw(desk: BunchContext): unknown {
	const laid = desk.toolState(photo);
	const words = laid ? "Another photograph…" : "Photograph behind…";
	const take = (file: File) => void takePhoto(desk, file);
	return html`<div class="actions">
		${chooseFile({ accept: PICTURES, label: "Photograph of a bunch", words, take })}
		${laid ? html`<panicle-photo-controls class="actions" .desk=${desk}></panicle-photo-controls>` : nothing}
	</div>`;
}
