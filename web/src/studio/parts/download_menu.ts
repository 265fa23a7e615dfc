import { html, nothing } from "lit";
import { icon } from "../../controls/icons";
import { NotFetched } from "../../files/exporter";
import { linkOf } from "../address";
import { type Download, fileName, formatsOf, save } from "../files/formats";
import { plantToSave } from "../files/plant_to_save";
import type { Studio } from "../studio";
import { isAltered } from "../title";
import { TRY_AGAIN } from "../types";
import type { ManyDialog } from "./many_dialog";
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

	protected override draw(studio: Studio): unknown {
		const { shown } = studio.state;
		const formats = shown && this.#open ? formatsOf(shown, studio.state.picture) : [];
		return html`<button
				class="button wine" type="button" aria-label="Download" aria-haspopup="menu" aria-expanded=${this.#open}
				?disabled=${!shown} @click=${this.#toggle}
			>${icon("download")}<span class="words">Download</span></button>
			${this.#making?.slow ? progress(this.#making) : nothing}
			${this.#open ? html`<div class="menu" role="menu" aria-label="Download" @keydown=${this.#keyDown}>${formats.map((format) => this.#item(format))}${manyItem(() => this.#many())}</div>` : nothing}
			<panicle-many .desk=${studio}></panicle-many>`;
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
		this.#making?.cancel.abort();
		const making: Making = { title: format.title, cancel: new AbortController(), slow: false };
		this.#making = making;
		const patience = setTimeout(() => {
			making.slow = true;
			this.requestUpdate();
		}, PATIENCE);
		const { signal } = making.cancel;
		try {
			const plant = await plantToSave(this.desk, signal);
			const name = fileName(plant.from, isAltered(plant.from, plant.model, this.desk.state.face?.tools));
			const blob = await format.make(plant, await linkOf(plant.model, plant.from), name, signal);
			signal.throwIfAborted();
			save(blob, `${name}${format.suffix}`);
		} catch (error) {
			if (!signal.aborted) this.#explain(error, format);
		} finally {
			clearTimeout(patience);
			if (this.#making === making) this.#making = undefined;
			this.requestUpdate();
		}
	}

	/** Its dialog is loaded when it is first asked for. */
	async #many(): Promise<void> {
		this.#close();
		const button = this.querySelector<HTMLElement>("button");
		try {
			await import("./many_dialog");
			button?.focus();
			await this.querySelector<ManyDialog>("panicle-many")?.open();
		} catch {
			const again = () => void this.#many();
			this.desk.notify("The series could not be asked for", ["Part of the page could not be fetched.", TRY_AGAIN], {
				again,
			});
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

function manyItem(open: () => Promise<void>): unknown {
	return html`<button type="button" role="menuitem" data-format="many" @click=${open}>
		Many in one ZIP…<small>A series of seeds, with what you vary, and a table</small>
	</button>`;
}

function progress({ title, cancel }: Making): unknown {
	return html`<div class="making" role="status">
		<span>Making the ${title}</span><progress aria-label="Making the file"></progress>
		<button class="button quiet" type="button" aria-label="Cancel the download" @click=${() => cancel.abort()}>Cancel</button>
	</div>`;
}

customElements.define("panicle-download", DownloadMenu);
