import { html, nothing } from "lit";
import { linkOf } from "../address";
import { FORMATS, type Format, fileName, save } from "../files/formats";
import type { Studio } from "../studio";
import { icon } from "./icons";
import { StudioElement } from "./studio_element";

/** `Download` and its menu of formats. */
export class DownloadMenu extends StudioElement {
	static override properties = { ...StudioElement.properties, open: { state: true } };
	declare private open: boolean;

	protected override draw(studio: Studio): unknown {
		const grownBy = studio.state.grown?.procedure;
		const formats = FORMATS.filter(
			({ key, procedure = grownBy }) => procedure === grownBy && (key !== "png" || studio.picture !== undefined),
		);
		return html`<button
				class="button wine" type="button" aria-label="Download" aria-haspopup="menu" aria-expanded=${Boolean(this.open)}
				?disabled=${!studio.state.grown} @click=${this.#toggle}
			>${icon("download")}<span class="words">Download</span></button>
			${this.open ? html`<div class="menu" role="menu" aria-label="Download" @keydown=${this.#keyDown}>${formats.map((format) => this.#item(format))}</div>` : nothing}`;
	}

	#item(format: Format): unknown {
		return html`<button type="button" role="menuitem" data-format=${format.key} @click=${() => this.#download(format)}>
			${format.title}<small>${format.about}</small>
		</button>`;
	}

	#toggle(): void {
		this.open = !this.open;
		if (!this.open) return;
		// What is saved is at rest, and measured.
		this.studio.setPlaying(false);
		void this.updateComplete.then(() => this.#items()[0]?.focus());
		window.addEventListener("pointerdown", this.#outside, { capture: true });
	}

	#close(): void {
		this.open = false;
		window.removeEventListener("pointerdown", this.#outside, { capture: true });
	}

	readonly #outside = (event: Event): void => {
		if (!event.composedPath().includes(this)) this.#close();
	};

	#keyDown(event: KeyboardEvent): void {
		const items = this.#items();
		const at = items.indexOf(document.activeElement as HTMLElement);
		const next = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: -1 }[event.key];
		if (event.key === "Escape" || event.key === "Tab") {
			this.#close();
			if (event.key === "Escape") this.querySelector<HTMLElement>("button")?.focus();
		} else if (next !== undefined) {
			event.preventDefault();
			items.at(next % items.length)?.focus();
		}
	}

	#items(): HTMLElement[] {
		return [...this.querySelectorAll<HTMLElement>("[role=menuitem]")];
	}

	async #download(format: Format): Promise<void> {
		this.#close();
		this.querySelector<HTMLElement>("button")?.focus();
		const { grown, grownFrom } = this.studio.state;
		if (!grown || !grownFrom) return;
		const name = fileName(grownFrom);
		try {
			const picture = () =>
				this.studio.picture?.() ?? Promise.reject(new Error("There is no 3-D view to take a picture of."));
			// The look may have changed since it grew; shape and look on screen are what is saved.
			const specimen = { ...grownFrom, look: this.studio.state.specimen.look };
			const blob = await format.make({ grown, specimen, link: await linkOf(specimen), name, picture });
			save(blob, `${name}${format.suffix}`);
		} catch (error) {
			this.studio.notify(`The ${format.title} could not be made`, [
				error instanceof Error ? error.message : String(error),
			]);
		}
	}
}

customElements.define("panicle-download", DownloadMenu);
