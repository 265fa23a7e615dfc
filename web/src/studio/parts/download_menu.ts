import { html, nothing } from "lit";
import { icon } from "../../controls/icons";
import { linkOf } from "../address";
import { type Download, fileName, formatsOf, save } from "../files/formats";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";

/** `Download` and its menu of formats. */
export class DownloadMenu extends StudioPart {
	#open = false;

	protected override draw(studio: Studio): unknown {
		const { shown } = studio.state;
		const formats = shown && this.#open ? formatsOf(shown, studio.state.picture) : [];
		return html`<button
				class="button wine" type="button" aria-label="Download" aria-haspopup="menu" aria-expanded=${this.#open}
				?disabled=${!shown} @click=${this.#toggle}
			>${icon("download")}<span class="words">Download</span></button>
			${this.#open ? html`<div class="menu" role="menu" aria-label="Download" @keydown=${this.#keyDown}>${formats.map((format) => this.#item(format))}</div>` : nothing}`;
	}

	#item(format: Download): unknown {
		return html`<button type="button" role="menuitem" data-format=${format.key} @click=${() => this.#download(format)}>
			${format.title}<small>${format.about}</small>
		</button>`;
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#close();
	}

	#toggle(): void {
		if (this.#open) {
			this.#close();
			return;
		}
		this.#open = true;
		this.requestUpdate();
		// What is saved is at rest, and measured.
		const { face } = this.desk.state;
		for (const tool of face?.tools ?? []) tool.rest?.(this.desk);
		void this.updateComplete.then(() => this.#items()[0]?.focus());
		window.addEventListener("pointerdown", this.#outside, { capture: true });
	}

	#close(): void {
		this.#open = false;
		this.requestUpdate();
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

	async #download(format: Download): Promise<void> {
		this.#close();
		this.querySelector<HTMLElement>("button")?.focus();
		const { shown, model, specimen } = this.desk.state;
		if (!shown) return;
		// The look may have changed since it grew; shape and look on screen are what is saved.
		const from = shown.model === model ? { ...shown.from, look: specimen.look } : shown.from;
		const name = fileName(from);
		try {
			const blob = await format.make({ ...shown, from }, await linkOf(shown.model, from), name);
			save(blob, `${name}${format.suffix}`);
		} catch (error) {
			this.desk.notify(`The ${format.title} could not be made`, [
				error instanceof Error ? error.message : String(error),
			]);
		}
	}
}

customElements.define("panicle-download", DownloadMenu);
