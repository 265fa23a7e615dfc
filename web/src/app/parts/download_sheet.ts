import { html, nothing } from "lit";
import { NotFetched } from "../../generate/files/exporter";
import type { Plant } from "../../plant/plant";
import { saveFile } from "../../ui/save_file";
import {
	type DownloadFormat,
	type DownloadOptions,
	type DownloadRequest,
	downloadFormats,
	fileName,
} from "../files/formats";
import { downloadRequestFor, MadeAhead, sizeInWords } from "../files/made_ahead";
import { plantToSave } from "../files/plant_to_save";
import { groupedFormats, type Recommended, recommendedFormats } from "../files/purposes";
import { canViewInRoom, FileAddress } from "../files/room";
import { text } from "../messages.generated";
import type { Studio } from "../studio";
import { isAltered } from "../title";
import { fetchFailed } from "../types";
import { BATCH, EMBED } from "./file_parts";
import { fileSettings } from "./file_settings";
import { SAVED } from "./late_parts";
import { type LatePart, openPart } from "./open_part";
import { restTools } from "./rest_tools";
import { sheetHeader } from "./sheet_header";
import { StudioPart } from "./studio_part";
import "../style/sheets.css";

/** The format that Quick Look shows. */
const ROOM_FORMAT = "usdz";
/** Files that take longer show progress and a Cancel button; milliseconds. */
const PROGRESS_DELAY = 200;

interface Making {
	readonly title: string;
	readonly cancel: AbortController;
	slow: boolean;
}

/** An entry of the sheet that opens another dialog. */
interface SheetAction {
	readonly key: string;
	readonly part: LatePart;
	title(): string;
	about(): string;
}

const ACTIONS: readonly SheetAction[] = [
	{ key: "batch", part: BATCH, title: () => text("download_batch"), about: () => text("download_batch_about") },
	{ key: "save", part: SAVED, title: () => text("download_save"), about: () => text("download_save_about") },
	{ key: "embed", part: EMBED, title: () => text("download_embed"), about: () => text("download_embed_about") },
];

/**
 * The download sheet: a recommended file for each purpose, all formats with their options, and further ways to save. One
 * file is made at a time: choosing another cancels the running one.
 */
export class DownloadSheet extends StudioPart {
	#isOpen = false;
	/** The element that had the focus when the sheet was opened. */
	#opener: HTMLElement | undefined;
	/** The file that is being made. */
	#making: Making | undefined;
	/** Options by the key of the format. */
	#options: Readonly<Record<string, DownloadOptions>> = {};
	/** The request that the sheet's sizes belong to, without options; undefined until the sheet is opened. */
	#request: DownloadRequest | undefined;
	readonly #ahead = new MadeAhead(() => this.requestUpdate());
	/** Whether the focus moves to the view in the user's room once it is listed. */
	#focusesRoom = false;
	readonly #roomAddress = new FileAddress();
	/** The plant whose sizes were computed last. */
	#sizedPlant: Plant | undefined;

	/** Returns the values whose change redraws the sheet. */
	protected override shows({ state: { shown, picture } }: Studio): readonly unknown[] {
		return [picture, this.#isOpen && shown];
	}

	/** Renders the progress of a slow file, and the sheet. */
	protected override draw({ state: { shown, picture } }: Studio): unknown {
		return html`${this.#making?.slow ? progress(this.#making, () => this.#cancel()) : nothing}
			<dialog class="help sheet-dialog" closedby="any" aria-labelledby=${this.idOf("title")} @close=${this.#closed}>
				${sheetHeader(this.idOf("title"), text("download"))}
				${this.#isOpen && shown ? this.#body(downloadFormats(shown, picture)) : nothing}
			</dialog>`;
	}

	/** Renders the recommended files, all formats by kind, and further ways to save. */
	#body(formats: readonly DownloadFormat[]): unknown {
		return html`${this.#room(formats)}<h3 id=${this.idOf("purposes")}>${text("download_purposes")}</h3>
			<ul class="purposes" aria-labelledby=${this.idOf("purposes")}>
				${this.#recommended(formats).map((one) => html`<li>${this.#purpose(one)}</li>`)}
			</ul>
			<h3>${text("download_all")}</h3>
			${groupedFormats(formats).map(
				({ title, formats: own }) => html`<h4>${title}</h4>
					<ul class="formats">${own.map((format) => html`<li>${this.#item(format)}</li>`)}</ul>`,
			)}
			<h4>${text("download_more")}</h4>
			<ul class="formats">${ACTIONS.map((action) => html`<li>${this.#action(action)}</li>`)}</ul>`;
	}

	/** Renders the link to the plant in the user's room, once its file is made; nothing where the browser cannot show it. */
	#room(formats: readonly DownloadFormat[]): unknown {
		const format = formats.find(({ key }) => key === ROOM_FORMAT);
		if (!format || !this.#request || !canViewInRoom()) return nothing;
		const file = this.#ahead.file(format, this.#withOptions(this.#request, format));
		const words =
			this.#problem(format) ?? (file ? text("room_about") : text("download_preparing", { file: format.title }));
		// Quick Look opens only links whose single element is a picture.
		const link = (made: Blob) => html`<a
				class="button wine" rel="ar" href=${this.#roomAddress.of(made)} download=${`${this.#request?.name}${format.suffix}`}
			><img src=${`${import.meta.env.BASE_URL}icons/panicle.svg`} width="20" height="20" alt="">${text("room")}</a>`;
		return html`<div class="room" role="status">${file ? link(file) : nothing}<p>${words}</p></div>`;
	}

	/** Returns the recommended formats; of those that were tried, only ones whose file could be made. */
	#recommended(formats: readonly DownloadFormat[]): Recommended[] {
		return recommendedFormats(formats, (format) => this.#problem(format) === undefined);
	}

	/** Renders the button of a recommended file. */
	#purpose({ purpose, title, format, openedBy }: Recommended): unknown {
		return html`<button type="button" data-purpose=${purpose} @click=${() => this.#download(format)}>
			<b>${title}</b> ${this.#size(format)} <span>${format.title}</span> <small>${openedBy}</small>
		</button>`;
	}

	/** Renders the button of a format with its options. */
	#item(format: DownloadFormat): unknown {
		return html`<button type="button" data-format=${format.key} @click=${() => this.#download(format)}>
				<b>${format.title}</b> ${this.#size(format)} <small>${this.#problem(format) ?? format.about}</small>
			</button>
			${fileSettings(format, this.#optionsOf(format), (options) => {
				this.#options = { ...this.#options, [format.key]: options };
				void this.#updateSizes();
			})}`;
	}

	/** Renders a button that opens another dialog. */
	#action({ key, part, title, about }: SheetAction): unknown {
		const run = () => {
			this.#close();
			void openPart(this.context, part);
		};
		return html`<button type="button" data-format=${key} @click=${run}>
			<b>${title()}</b> <small>${about()}</small>
		</button>`;
	}

	/** Renders the size of a file; "…" until it is made, "–" if it cannot be made. */
	#size(format: DownloadFormat): unknown {
		if (!format.sized) return nothing;
		const file = this.#request && this.#ahead.file(format, this.#withOptions(this.#request, format));
		const unknown = this.#problem(format) === undefined ? "…" : "–";
		return html`<span class="size">${file ? sizeInWords(file.size) : unknown}</span>`;
	}

	/** Returns the reason why a file cannot be made; undefined if it can, or has not been tried. */
	#problem(format: DownloadFormat): string | undefined {
		return this.#request && this.#ahead.problem(format, this.#withOptions(this.#request, format));
	}

	/** Returns the chosen options of a format. */
	#optionsOf({ key }: DownloadFormat): DownloadOptions {
		return this.#options[key] ?? {};
	}

	/** Returns the request with the chosen options of a format. */
	#withOptions(request: DownloadRequest, format: DownloadFormat): DownloadRequest {
		return { ...request, options: this.#optionsOf(format) };
	}

	/**
	 * Opens the sheet with the focus on the first purpose, or on the view in the user's room; the browser traps and
	 * restores the focus.
	 */
	async open(at: "purposes" | "room" = "purposes"): Promise<void> {
		const { shown } = this.context.state;
		if (!shown || this.#isOpen) return;
		this.#opener = document.activeElement instanceof HTMLElement ? document.activeElement : undefined;
		this.#isOpen = true;
		// A saved plant must be at rest, with measures.
		restTools(this.context);
		this.requestUpdate();
		await this.updateComplete;
		this.querySelector("dialog")?.showModal();
		this.#focusesRoom = at === "room";
		this.querySelector<HTMLElement>("[data-purpose]")?.focus();
	}

	/** Makes a file of the plant in view and saves it, without the sheet. @param key names its format */
	async download(key: string): Promise<void> {
		const { shown, picture } = this.context.state;
		const format = shown && downloadFormats(shown, picture).find((each) => each.key === key);
		if (!format) return;
		this.#opener = document.activeElement instanceof HTMLElement ? document.activeElement : undefined;
		restTools(this.context);
		await this.#download(format);
	}

	/** Computes the sizes anew when the plant in view changes while the sheet is open. */
	protected override updated(): void {
		const room = this.#focusesRoom ? this.querySelector<HTMLElement>(".room:has(a)") : null;
		if (room) {
			this.#focusesRoom = false;
			room.querySelector("a")?.focus();
		}
		const grown = this.context.state.shown?.grown;
		if (!this.#isOpen || grown === this.#sizedPlant) return;
		this.#sizedPlant = grown;
		void this.#updateSizes();
	}

	/** Makes the sheet's files ahead, the recommended ones first, to show their sizes. */
	async #updateSizes(): Promise<void> {
		const request = await this.#requestFor().catch(() => undefined);
		if (!request || !this.#isOpen) return;
		this.#request = request;
		const formats = downloadFormats(request.plant, undefined);
		const first = recommendedFormats(formats).map(({ format }) => format);
		const room = canViewInRoom() ? formats.filter(({ key }) => key === ROOM_FORMAT) : [];
		const wanted = [...new Set([...room, ...first, ...formats])];
		await this.#ahead.start(wanted.map((format) => ({ format, request: this.#withOptions(request, format) })));
	}

	/** Returns a request without options for the plant on the controls. */
	async #requestFor(signal?: AbortSignal): Promise<DownloadRequest> {
		const plant = await plantToSave(this.context, signal);
		const name = fileName(plant.from, isAltered(plant.from, plant.model, this.context.state.modelUi?.tools));
		return downloadRequestFor(plant, name, {});
	}

	/** Stops making files when the sheet is removed. */
	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#closed();
	}

	/** Closes the dialog. */
	#close(): void {
		this.querySelector("dialog")?.close();
		// The browser sends the dialog's event later.
		this.#closed();
	}

	/** Stops making files ahead after the dialog has been closed. */
	#closed(): void {
		if (!this.#isOpen) return;
		this.#isOpen = false;
		this.#sizedPlant = undefined;
		this.#ahead.stop();
		this.#roomAddress.release();
		this.requestUpdate();
	}

	/** Cancels the running file; the focus moves to the button that opened the sheet, since Cancel disappears. */
	#cancel(): void {
		this.#making?.cancel.abort();
		this.#opener?.focus();
	}

	/**
	 * Makes a file and saves it; another download cancels the running one. Progress is shown after PROGRESS_DELAY (ms).
	 */
	async #download(format: DownloadFormat): Promise<void> {
		this.#close();
		this.#making?.cancel.abort();
		const making: Making = { title: format.title, cancel: new AbortController(), slow: false };
		this.#making = making;
		const delay = setTimeout(() => {
			making.slow = true;
			this.requestUpdate();
		}, PROGRESS_DELAY);
		const { signal } = making.cancel;
		try {
			const request = this.#withOptions(await this.#requestFor(signal), format);
			const blob = this.#ahead.file(format, request) ?? (await format.make(request, signal));
			signal.throwIfAborted();
			const name = `${request.name}${format.suffix}`;
			saveFile(blob, name);
			this.context.notify(text("download_done", { file: name }), [], { topic: "download", brief: true });
		} catch (error) {
			if (!signal.aborted) this.#explain(error, format);
		} finally {
			clearTimeout(delay);
			if (!this.#isOpen) this.#ahead.clear();
			if (this.#making === making) this.#making = undefined;
			this.requestUpdate();
		}
	}

	/** Shows a notice about a file that could not be made. */
	#explain(error: unknown, format: DownloadFormat): void {
		const title = text("download_file_failed", { file: format.title });
		const reason = error instanceof Error ? error.message : String(error);
		if (error instanceof NotFetched)
			this.context.notify(title, fetchFailed(), { topic: "download", again: () => void this.#download(format) });
		else this.context.notify(title, [reason], { topic: "download" });
	}
}

/** Renders the progress of a file, with a button that cancels it. */
function progress({ title }: Making, cancel: () => void): unknown {
	return html`<div class="making" role="status">
		<span>${text("download_preparing", { file: title })}</span><progress aria-label=${text("download_progress")}></progress>
		<button class="button quiet" type="button" aria-label=${text("download_cancel")} @click=${cancel}>${text("cancel")}</button>
	</div>`;
}

customElements.define("panicle-downloads", DownloadSheet);
