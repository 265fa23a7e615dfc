import { html, nothing } from "lit";
import type { Plant } from "../../plant/plant";
import { icon } from "../../ui/icons";
import type { DownloadFormat, DownloadRequest } from "../files/formats";
import type { MadeAhead } from "../files/made_ahead";
import type { Studio } from "../studio";
import { isAltered } from "../title";
import { TRY_AGAIN } from "../types";
import type { MenuAction } from "./menu_actions";
import { StudioPart } from "./studio_part";

/** Files that take longer show progress and a Cancel button; milliseconds. */
const PROGRESS_DELAY = 200;

type Offered = typeof import("../files/offered");

interface Making {
	readonly title: string;
	readonly cancel: AbortController;
	slow: boolean;
}

/** The `Download` button and its menu of formats. One file is made at a time: choosing another cancels the running one. */
export class DownloadMenu extends StudioPart {
	/** The menu's modules, while the menu is open. */
	#offered: Offered | undefined;
	/** The file that is being made. */
	#making: Making | undefined;
	#options: DownloadRequest["options"] = {};
	/** The request that the menu's sizes belong to, while the menu is open. */
	#request: DownloadRequest | undefined;
	#ahead: MadeAhead | undefined;
	/** The plant whose sizes were computed last. */
	#sizedPlant: Plant | undefined;

	protected override shows({ state: { shown, picture } }: Studio): readonly unknown[] {
		return [picture, this.#offered ? shown : shown !== undefined];
	}

	protected override draw(studio: Studio): unknown {
		const { shown } = studio.state;
		const offered = this.#offered;
		return html`<button
				class="button wine" type="button" aria-label="Download" aria-haspopup="menu" aria-expanded=${offered !== undefined}
				?disabled=${!shown} @click=${this.#toggle}
			>${icon("download")}<span class="words">Download</span></button>
			${this.#making?.slow ? progress(this.#making, () => this.#cancel()) : nothing}
			${offered && shown ? this.#menu(offered, offered.downloadFormats(shown, studio.state.picture)) : nothing}
			<panicle-many .context=${studio}></panicle-many><panicle-embed .context=${studio}></panicle-embed>`;
	}

	#menu(offered: Offered, formats: readonly DownloadFormat[]): unknown {
		return html`<div class="menu" @keydown=${this.#keyDown} @focusout=${this.#focusOut}>
			<div role="menu" aria-label="Download">${formats.map((format) => this.#item(offered, format))}${offered.menuActions(this.context).map((action) => this.#action(action))}</div>
			${offered.fileSettings(this.#options, (options) => {
				this.#options = options;
				void this.#updateSizes(offered);
			})}
		</div>`;
	}

	#item(offered: Offered, format: DownloadFormat): unknown {
		const file = this.#request && this.#ahead?.file(format, this.#request);
		return html`<button type="button" role="menuitem" data-format=${format.key} @click=${() => this.#download(offered, format)}>
			${format.title}${format.sized ? html` <span class="size">${file ? offered.sizeInWords(file.size) : "…"}</span>` : nothing}<small>${format.about}</small>
		</button>`;
	}

	#action(action: MenuAction): unknown {
		const run = () => {
			this.#leave();
			void action.run(this.context, this);
		};
		return html`<button type="button" role="menuitem" data-format=${action.key} @click=${run}>
			${action.title}<small>${action.about}</small>
		</button>`;
	}

	/** Computes the sizes anew when the plant in view changes while the menu is open. */
	protected override updated(): void {
		const grown = this.context.state.shown?.grown;
		if (!this.#offered || grown === this.#sizedPlant) return;
		this.#sizedPlant = grown;
		void this.#updateSizes(this.#offered);
	}

	/** Cancels the running file; the focus moves to the menu's button, since the Cancel button disappears. */
	#cancel(): void {
		this.#making?.cancel.abort();
		this.querySelector<HTMLElement>("button")?.focus();
	}

	/** Makes the menu's files ahead, to show their sizes. */
	async #updateSizes(offered: Offered): Promise<void> {
		const request = await this.#requestFor(offered).catch(() => undefined);
		if (!request || !this.#offered) return;
		this.#request = request;
		this.#ahead ??= new offered.MadeAhead(() => this.requestUpdate());
		await this.#ahead.start(offered.downloadFormats(request.plant, undefined), request);
	}

	async #requestFor(
		{ plantToSave, fileName, downloadRequestFor }: Offered,
		signal?: AbortSignal,
	): Promise<DownloadRequest> {
		const plant = await plantToSave(this.context, signal);
		const name = fileName(plant.from, isAltered(plant.from, plant.model, this.context.state.modelUi?.tools));
		return downloadRequestFor(plant, name, this.#options);
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#close();
	}

	async #toggle(): Promise<void> {
		if (this.#offered) {
			this.#close();
			return;
		}
		const offered = await import("../files/offered").catch(() => undefined);
		if (!offered) {
			const details = ["Part of the page could not be fetched.", TRY_AGAIN];
			this.context.notify("The downloads could not be shown", details, { again: () => void this.#toggle() });
			return;
		}
		this.#offered = offered;
		this.requestUpdate();
		// A saved plant must be at rest, with measures: stop animations.
		const { modelUi } = this.context.state;
		for (const tool of modelUi?.tools ?? []) tool.rest?.(this.context);
		void this.updateComplete.then(() => this.#items()[0]?.focus());
		window.addEventListener("pointerdown", this.#outside, { capture: true });
	}

	#close(): void {
		this.#offered = undefined;
		this.#sizedPlant = undefined;
		this.#ahead?.stop();
		this.requestUpdate();
		window.removeEventListener("pointerdown", this.#outside, { capture: true });
	}

	/** Closes the menu; the focus returns to its button. */
	#leave(): void {
		this.#close();
		this.querySelector<HTMLElement>("button")?.focus();
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
			// Escape must not close anything else or clear a selection.
			event.preventDefault();
			this.#leave();
		} else if (at >= 0 && next !== undefined) {
			event.preventDefault();
			items.at(next % items.length)?.focus();
		}
	}

	#items(): HTMLElement[] {
		return [...this.querySelectorAll<HTMLElement>("[role=menuitem]")];
	}

	async #download(offered: Offered, format: DownloadFormat): Promise<void> {
		this.#leave();
		this.#making?.cancel.abort();
		const making: Making = { title: format.title, cancel: new AbortController(), slow: false };
		this.#making = making;
		const patience = setTimeout(() => {
			making.slow = true;
			this.requestUpdate();
		}, PROGRESS_DELAY);
		const { signal } = making.cancel;
		try {
			const request = await this.#requestFor(offered, signal);
			const blob = this.#ahead?.file(format, request) ?? (await format.make(request, signal));
			signal.throwIfAborted();
			offered.saveFile(blob, `${request.name}${format.suffix}`);
		} catch (error) {
			if (!signal.aborted) this.#explain(offered, error, format);
		} finally {
			clearTimeout(patience);
			if (!this.#offered) this.#ahead?.clear();
			if (this.#making === making) this.#making = undefined;
			this.requestUpdate();
		}
	}

	#explain(offered: Offered, error: unknown, format: DownloadFormat): void {
		const title = `The ${format.title} could not be made`;
		const text = error instanceof Error ? error.message : String(error);
		if (error instanceof offered.NotFetched)
			this.context.notify(title, [text, TRY_AGAIN], { again: () => void this.#download(offered, format) });
		else this.context.notify(title, [text]);
	}
}

function progress({ title }: Making, cancel: () => void): unknown {
	return html`<div class="making" role="status">
		<span>Making the ${title}</span><progress aria-label="Making the file"></progress>
		<button class="button quiet" type="button" aria-label="Cancel the download" @click=${cancel}>Cancel</button>
	</div>`;
}

customElements.define("panicle-download", DownloadMenu);
