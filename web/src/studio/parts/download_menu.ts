import { html, nothing } from "lit";
import { icon } from "../../controls/icons";
import { LOW_TRIANGLES, THICKNESS } from "../../export/plant_files";
import { NotFetched } from "../../files/exporter";
import { type Asked, type Download, fileName, formatsOf, save } from "../files/formats";
import { askedOf, MadeAhead, sizeInWords } from "../files/made_ahead";
import { plantToSave } from "../files/plant_to_save";
import type { Studio } from "../studio";
import { isAltered } from "../title";
import { TRY_AGAIN } from "../types";
import { fileSettings } from "./file_settings";
import { StudioPart } from "./studio_part";

/** What takes longer than this shows that it is being made, and can be cancelled; milliseconds. */
const PATIENCE = 200;

interface Making {
	readonly title: string;
	readonly cancel: AbortController;
	slow: boolean;
}

/** `Download` and its menu of formats. One file is made at a time: the next takes the place of one that still is. */
export class DownloadMenu extends StudioPart {
	#open = false;
	/** The file that is being made. */
	#making: Making | undefined;
	#options: Asked["options"] = { triangles: LOW_TRIANGLES, thickness: THICKNESS };
	/** What the sizes are of, while the menu is open. */
	#asked: Asked | undefined;
	readonly #ahead = new MadeAhead(() => this.requestUpdate());

	protected override draw(studio: Studio): unknown {
		const { shown } = studio.state;
		const formats = shown && this.#open ? formatsOf(shown, studio.state.picture) : [];
		return html`<button
				class="button wine" type="button" aria-label="Download" aria-haspopup="menu" aria-expanded=${this.#open}
				?disabled=${!shown} @click=${this.#toggle}
			>${icon("download")}<span class="words">Download</span></button>
			${this.#making?.slow ? progress(this.#making) : nothing}
			${this.#open ? this.#menu(formats) : nothing}`;
	}

	#menu(formats: readonly Download[]): unknown {
		return html`<div class="menu" @keydown=${this.#keyDown} @focusout=${this.#focusOut}>
			<div role="menu" aria-label="Download">${formats.map((format) => this.#item(format))}</div>
			${fileSettings(this.#options, (options) => {
				this.#options = options;
				void this.#tellSizes();
			})}
		</div>`;
	}

	#item(format: Download): unknown {
		const file = this.#asked && this.#ahead.file(format, this.#asked);
		return html`<button type="button" role="menuitem" data-format=${format.key} @click=${() => this.#download(format)}>
			${format.title}${format.sized ? html` <span class="size">${file ? sizeInWords(file.size) : "…"}</span>` : nothing}<small>${format.about}</small>
		</button>`;
	}

	/** Makes what the menu offers, to tell how large it is. */
	async #tellSizes(): Promise<void> {
		const asked = await this.#ask().catch(() => undefined);
		if (!asked || !this.#open) return;
		this.#asked = asked;
		await this.#ahead.start(formatsOf(asked.plant, undefined), asked);
	}

	async #ask(signal?: AbortSignal): Promise<Asked> {
		const plant = await plantToSave(this.desk, signal);
		const name = fileName(plant.from, isAltered(plant.from, plant.model, this.desk.state.face?.tools));
		return askedOf(plant, name, this.#options);
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
		void this.#tellSizes();
		window.addEventListener("pointerdown", this.#outside, { capture: true });
	}

	#close(): void {
		this.#open = false;
		this.#ahead.stop();
		this.requestUpdate();
		window.removeEventListener("pointerdown", this.#outside, { capture: true });
	}

	readonly #outside = (event: Event): void => {
		if (!event.composedPath().includes(this)) this.#close();
	};

	#focusOut({ relatedTarget }: FocusEvent): void {
		if (relatedTarget instanceof Node && !this.contains(relatedTarget)) this.#close();
	}

	#keyDown(event: KeyboardEvent): void {
		const items = this.#items();
		const at = items.indexOf(document.activeElement as HTMLElement);
		const next = { ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: -1 }[event.key];
		if (event.key === "Escape") {
			this.#close();
			this.querySelector<HTMLElement>("button")?.focus();
		} else if (at < 0) {
			return;
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
		this.#making?.cancel.abort();
		const making: Making = { title: format.title, cancel: new AbortController(), slow: false };
		this.#making = making;
		const patience = setTimeout(() => {
			making.slow = true;
			this.requestUpdate();
		}, PATIENCE);
		const { signal } = making.cancel;
		try {
			const asked = await this.#ask(signal);
			const blob = this.#ahead.file(format, asked) ?? (await format.make(asked, signal));
			signal.throwIfAborted();
			save(blob, `${asked.name}${format.suffix}`);
		} catch (error) {
			if (!signal.aborted) this.#explain(error, format);
		} finally {
			clearTimeout(patience);
			this.#ahead.clear();
			if (this.#making === making) this.#making = undefined;
			this.requestUpdate();
		}
	}

	#explain(error: unknown, format: Download): void {
		const title = `The ${format.title} could not be made`;
		const text = error instanceof Error ? error.message : String(error);
		if (error instanceof NotFetched)
			this.desk.notify(title, [text, TRY_AGAIN], { again: () => void this.#download(format) });
		else this.desk.notify(title, [text]);
	}
}

function progress({ title, cancel }: Making): unknown {
	return html`<div class="making" role="status">
		<span>Making the ${title}</span><progress aria-label="Making the file"></progress>
		<button class="button quiet" type="button" aria-label="Cancel the download" @click=${() => cancel.abort()}>Cancel</button>
	</div>`;
}

customElements.define("panicle-download", DownloadMenu);
