import { html, nothing } from "lit";
import { isPicture, PICTURES, PictureError, readBitmap } from "../../../controls/read_bitmap";
import { FILE_TOPIC } from "../../../controls/tool";
import type { Photo } from "../photo/photo";
import type { View } from "../profile/handles";
import type { BunchDesk, BunchTool } from "./desk";

/** A photograph that lies behind a flat view, to fit the handles to. It is the page's alone: in no link, in no file, sent nowhere. */
export const photo: BunchTool<Photo | undefined> = {
	name: "photo",
	initial: undefined,
	panel: { group: "shape", place: "below", draw },
	drop: {
		words: "a photograph goes behind the front view",
		takes: isPicture,
		take: (desk, file) => void placePhoto(desk, file),
	},
};

/** The longer side that is kept, in pixels: as many as a view on a large screen shows. */
const LONGEST = 2000;
const OPACITY = 0.6;

/** Lays a picture behind a view, as high as the bunch; what is wrong with it is said. */
export async function placePhoto(desk: BunchDesk, file: Blob): Promise<void> {
	const again = () => void placePhoto(desk, file);
	const lay = await Promise.all([import("../photo/photo"), import("../photo/photo_view")]).catch(() => undefined);
	if (!lay) {
		desk.notify("The photograph was not taken", ["Part of the page could not be fetched."], {
			topic: FILE_TOPIC,
			again,
		});
		return;
	}
	try {
		const picture = await readBitmap(file, LONGEST);
		const before = desk.toolState(photo);
		const place = lay[0].fitted(picture, desk.state.specimen.parameters.l);
		desk.setToolState(photo, { picture, ...place, view: before?.view ?? "front", opacity: OPACITY, loose: true });
		before?.picture.close();
		desk.notify(
			"The photograph lies behind the view",
			["Drag it to its place, scale it with the wheel or two fingers, then fasten it and fit the handles."],
			{ topic: FILE_TOPIC, brief: true },
		);
	} catch (error) {
		if (!(error instanceof PictureError)) throw error;
		desk.notify("The photograph was not taken", [error.message], { topic: FILE_TOPIC });
	}
}

export function removePhoto(desk: BunchDesk): void {
	desk.toolState(photo)?.picture.close();
	desk.setToolState(photo, undefined);
}

/** Changes what there is of it; nothing where it has gone. */
export function changePhoto(desk: BunchDesk, change: Partial<Photo>): void {
	const before = desk.toolState(photo);
	if (before) desk.setToolState(photo, { ...before, ...change });
}

function draw(desk: BunchDesk): unknown {
	const laid = desk.toolState(photo);
	const choose = (event: Event) => (event.currentTarget as Element).parentElement?.querySelector("input")?.click();
	const chosen = (event: Event) => {
		const input = event.currentTarget as HTMLInputElement;
		const file = input.files?.[0];
		input.value = ""; // the same file may be chosen again
		if (file) void placePhoto(desk, file);
	};
	return html`<div class="actions">
		<input type="file" hidden accept=${PICTURES} aria-label="Photograph of a bunch" @change=${chosen}>
		<button class="button" type="button" @click=${choose}>${laid ? "Another photograph…" : "Photograph behind…"}</button>
		${laid ? placed(desk, laid) : nothing}
	</div>`;
}

const VIEWS: readonly (readonly [View, string])[] = [
	["front", "Front"],
	["side", "Side"],
];

function placed(desk: BunchDesk, { view, opacity, loose }: Photo): unknown {
	return html`<button
			class="button" type="button" aria-pressed=${loose} @click=${() => changePhoto(desk, { loose: !loose })}
		>Shift photograph</button>
		<button class="button" type="button" @click=${() => removePhoto(desk)}>Remove photograph</button>
		<label>Behind <select @change=${(event: Event) => changePhoto(desk, { view: (event.target as HTMLSelectElement).value as View })}>
			${VIEWS.map(([key, words]) => html`<option value=${key} ?selected=${key === view}>${words}</option>`)}
		</select></label>
		<label>Opacity <input
			type="range" min="0.1" max="1" step="0.05" .value=${String(opacity)}
			@input=${(event: Event) => changePhoto(desk, { opacity: Number((event.target as HTMLInputElement).value) })}
		></label>`;
}
