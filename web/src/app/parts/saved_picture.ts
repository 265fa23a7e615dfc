import type { Library } from "../saved/library";
import { readPicture, type Saved } from "../saved/saved";
import { THUMBNAIL } from "../saved/thumbnail";

/** Distance from the viewport within which a picture is decoded. */
const NEAR = "200px";

/** The picture of a saved specimen, drawn on a canvas: the page's content security policy forbids blob and data addresses. */
export class SavedPicture extends HTMLElement {
	#saved: Saved | undefined;
	/** The library that has the picture; set before `saved`. */
	library: Library | undefined;

	/** Sets the specimen; the picture of a specimen never changes. */
	set saved(saved: Saved) {
		if (saved.id === this.#saved?.id) return;
		this.#saved = saved;
		this.replaceChildren();
		inSight.observe(this);
	}

	connectedCallback(): void {
		if (this.#saved && !this.firstChild) inSight.observe(this);
	}

	disconnectedCallback(): void {
		inSight.unobserve(this);
	}

	async draw(): Promise<void> {
		if (!this.#saved) return;
		const [{ id, picture }] = (await this.library?.withPictures([this.#saved])) ?? [this.#saved];
		if (!picture || !("value" in readPicture(picture))) return;
		const bitmap = await createImageBitmap(new Blob([picture], { type: "image/jpeg" })).catch(() => undefined);
		if (!bitmap || id !== this.#saved?.id) return;
		const canvas = Object.assign(document.createElement("canvas"), THUMBNAIL);
		canvas.getContext("2d")?.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
		bitmap.close();
		this.replaceChildren(canvas);
	}
}

const inSight = new IntersectionObserver(
	(seen) => {
		for (const { isIntersecting, target } of seen) {
			if (!isIntersecting) continue;
			inSight.unobserve(target);
			void (target as SavedPicture).draw();
		}
	},
	{ rootMargin: NEAR },
);

customElements.define("panicle-saved-picture", SavedPicture);
