import { drawnJpeg } from "../saved/drawn_jpeg";
import type { Library } from "../saved/library";
import type { Saved } from "../saved/saved";

/** Distance from the viewport within which a picture is decoded. */
const NEAR = "200px";

/**
 * The picture of a saved specimen, drawn on a canvas: the page's content security policy forbids blob and data
 * addresses.
 */
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

	/** Waits until the picture is near the viewport, if it is not drawn yet. */
	connectedCallback(): void {
		if (this.#saved && !this.firstChild) inSight.observe(this);
	}

	/** Stops waiting. */
	disconnectedCallback(): void {
		inSight.unobserve(this);
	}

	/** Decodes the picture and draws it, unless another plant has been set meanwhile. */
	async draw(): Promise<void> {
		if (!this.#saved) return;
		const [{ id, picture }] = (await this.library?.withPictures([this.#saved])) ?? [this.#saved];
		const canvas = picture && (await drawnJpeg(picture));
		if (canvas && id === this.#saved?.id) this.replaceChildren(canvas);
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
