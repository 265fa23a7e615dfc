import { html, nothing } from "lit";
import type { Plant } from "../../plant/plant";
import { icon } from "../../ui/icons";
import type { Asked, Download } from "../files/formats";
import type { MadeAhead } from "../files/made_ahead";
import type { Studio } from "../studio";
import { isAltered } from "../title";
import { TRY_AGAIN } from "../types";
import type { MenuAction } from "./menu_actions";
import { StudioPart } from "./studio_part";

/** What takes longer than this shows that it is being made, and can be cancelled; milliseconds. */
const PATIENCE = 200;

type Offered = typeof import("../files/offered");

interface Making {
	readonly title: string;
	readonly cancel: AbortController;
	slow: boolean;
}

/** `Download` and its menu of formats. One file is made at a time: the next takes the place of one that still is. */
export class DownloadMenu extends StudioPart {
	/** What can be had, while the menu is open. */
	#offered: Offered | undefined;
	/** The file that is being made. */
	#making: Making | undefined;
	#options: Asked["options"] = {};
	/** What the sizes are of, while the menu is open. */
	#asked: Asked | undefined;
	#ahead: MadeAhead | undefined;
	/** The plant that sizes were last asked of. */
	#toldOf: Plant | undefined;

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
			${offered && shown ? this.#menu(offered, offered.formatsOf(shown, studio.state.picture)) : nothing}
			<panicle-many .context=${studio}></panicle-many><panicle-embed .context=${studio}></panicle-embed>`;
	}

	#menu(offered: Offered, formats: readonly Download[]): unknown {
		return html`<div class="menu" @keydown=${this.#keyDown} @focusout=${this.#focusOut}>
			<div role="menu" aria-label="Download">${formats.map((format) => this.#item(offered, format))}${offered.menuActions(this.context).map((action) => this.#action(action))}</div>
			${offered.fileSettings(this.#options, (options) => {
				this.#options = options;
				void this.#tellSizes(offered);
			})}
		</div>`;
	}

	#item(offered: Offered, format: Download): unknown {
		const file = this.#asked && this.#ahead?.file(format, this.#asked);
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

	/** Sizes are those of the plant in view: they follow it while the menu is open. */
	protected override updated(): void {
		const grown = this.context.state.shown?.grown;
		if (!this.#offered || grown === this.#toldOf) return;
		this.#toldOf = grown;
		void this.#tellSizes(this.#offered);
	}

	/** The button with Cancel on it goes: the focus stays near. */
	#cancel(): void {
		this.#making?.cancel.abort();
		this.querySelector<HTMLElement>("button")?.focus();
	}

	/** Makes what the menu offers, to tell how large it is. */
	async #tellSizes(offered: Offered): Promise<void> {
		const asked = await this.#ask(offered).catch(() => undefined);
		if (!asked || !this.#offered) return;
		this.#asked = asked;
		this.#ahead ??= new offered.MadeAhead(() => this.requestUpdate());
		await this.#ahead.start(offered.formatsOf(asked.plant, undefined), asked);
	}

	async #ask({ plantToSave, fileName, askedOf }: Offered, signal?: AbortSignal): Promise<Asked> {
		const plant = await plantToSave(this.context, signal);
		const name = fileName(plant.from, isAltered(plant.from, plant.model, this.context.state.face?.tools));
		return askedOf(plant, name, this.#options);
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
		// What is saved is at rest, and measured.
		const { face } = this.context.state;
		for (const tool of face?.tools ?? []) tool.rest?.(this.context);
		void this.updateComplete.then(() => this.#items()[0]?.focus());
		window.addEventListener("pointerdown", this.#outside, { capture: true });
	}

	#close(): void {
		this.#offered = undefined;
		this.#toldOf = undefined;
		this.#ahead?.stop();
		this.requestUpdate();
		window.removeEventListener("pointerdown", this.#outside, { capture: true });
	}

	/** Closes the menu; the focus goes back to its button. */
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
			// So that it closes nothing else, nor lets go of what is chosen.
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

	async #download(offered: Offered, format: Download): Promise<void> {
		this.#leave();
		this.#making?.cancel.abort();
		const making: Making = { title: format.title, cancel: new AbortController(), slow: false };
		this.#making = making;
		const patience = setTimeout(() => {
			making.slow = true;
			this.requestUpdate();
		}, PATIENCE);
		const { signal } = making.cancel;
		try {
			const asked = await this.#ask(offered, signal);
			const blob = this.#ahead?.file(format, asked) ?? (await format.make(asked, signal));
			signal.throwIfAborted();
			offered.saveFile(blob, `${asked.name}${format.suffix}`);
		} catch (error) {
			if (!signal.aborted) this.#explain(offered, error, format);
		} finally {
			clearTimeout(patience);
			if (!this.#offered) this.#ahead?.clear();
			if (this.#making === making) this.#making = undefined;
			this.requestUpdate();
		}
	}

	#explain(offered: Offered, error: unknown, format: Download): void {
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
