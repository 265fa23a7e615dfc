import { html, nothing } from "lit";
import { saveFile } from "../../ui/save_file";
import { linkOf, notInLink } from "../address";
import { copyPicture, pictureOf } from "../files/copy_picture";
import { fileName } from "../files/formats";
import { LONGEST_QR_LINK, type QrModules, qrModules, qrPath, qrPng, qrSvg } from "../files/qr_code";
import { text } from "../messages.generated";
import type { Studio } from "../studio";
import { isAltered, titleOf } from "../title";
import { EMBED } from "./file_parts";
import { openPart } from "./open_part";
import { restTools } from "./rest_tools";
import { sheetHeader } from "./sheet_header";
import { StudioPart } from "./studio_part";
import "../style/sheets.css";

/** Least width of the QR code, CSS pixels. */
const QR_WIDTH = 200;
/** Height of the picture's preview, in pixels: twice that of its place in the sheet. */
const PREVIEW_HEIGHT = 360;

/** The plant that the sheet was opened for. */
interface Shared {
	readonly link: string;
	readonly title: string;
	/** The name of its files, without ending. */
	readonly name: string;
	/** The parts that the link does not hold, and further remarks, a sentence each. */
	readonly remarks: readonly string[];
	/** The QR code of the link; undefined if the link is too long. */
	readonly code: QrModules | undefined;
}

/** The parts of the sheet with buttons that report a result. */
type SharePart = "link" | "qr" | "picture";

/** The share sheet: the link, the system's share dialog, a QR code, a picture, and the embed code of a plant. */
export class ShareSheet extends StudioPart {
	#shared: Shared | undefined;
	/** Whether the picture has a transparent background. */
	#alone = false;
	/** The result of the last action, and the part of the sheet that has its button. */
	#result: { readonly part: SharePart; readonly words: string } | undefined;

	/** Returns the values whose change redraws the sheet. */
	protected override shows({ state: { picture } }: Studio): readonly unknown[] {
		return [this.#shared && picture];
	}

	/** Renders the sheet, empty while it is closed. */
	protected override draw(studio: Studio): unknown {
		return html`<dialog class="help sheet-dialog share" closedby="any" aria-labelledby=${this.idOf("title")} @close=${this.#closed}>
			${sheetHeader(this.idOf("title"), text("share_title"))}
			${this.#shared ? this.#body(this.#shared, studio) : nothing}
		</dialog>`;
	}

	/** Renders the result of the last action if its button is in this part of the sheet, next to the button. */
	#resultOf(part: SharePart): unknown {
		return html`<p class="result" role="status">${this.#result?.part === part ? this.#result.words : nothing}</p>`;
	}

	/** Renders the link, the QR code, the picture and the embed code. */
	#body(shared: Shared, { state: { picture } }: Studio): unknown {
		return html`<section>
				<div class="link">
					<input readonly aria-label=${text("share_link")} .value=${shared.link} @focus=${selectAll}>
					<button class="button wine" type="button" data-copy @click=${() => this.#copyLink(shared)}>${text("copy_link")}</button>
					${canShare() ? html`<button class="button" type="button" @click=${() => this.#shareWith(shared)}>${text("share_with")}</button>` : nothing}
				</div>
				${this.#resultOf("link")}
				<p>${text("share_link_about")}</p>
				${shared.remarks.map((line) => html`<p class="remark">${line}</p>`)}
			</section>
			<div class="sides">
				<section aria-labelledby=${this.idOf("qr")}>
					<h3 id=${this.idOf("qr")}>${text("share_qr")}</h3>
					${shared.code ? this.#qr(shared, shared.code) : html`<p>${text("share_qr_too_long", { length: shared.link.length, limit: LONGEST_QR_LINK })}</p>`}
				</section>
				<section aria-labelledby=${this.idOf("picture")}>
					<h3 id=${this.idOf("picture")}>${text("share_picture")}</h3>
					${picture ? this.#picture(shared) : html`<p>${text("picture_no_view")}</p>`}
				</section>
			</div>
			<section aria-labelledby=${this.idOf("embed")}>
				<h3 id=${this.idOf("embed")}>${text("share_embed")}</h3>
				<div class="choices">
					<p>${text("share_embed_about")}</p>
					<button class="button" type="button" @click=${this.#embed}>${text("download_embed")}</button>
				</div>
			</section>`;
	}

	/** Renders the QR code, with buttons that save it. */
	#qr({ name }: Shared, code: QrModules): unknown {
		const size = code.length;
		// Whole pixels per module, at least two.
		const width = size * Math.max(2, Math.ceil(QR_WIDTH / size));
		const save = (blob: Blob, ending: string) => this.#save("qr", blob, `${name}-qr.${ending}`);
		return html`<svg class="qr" role="img" aria-label=${text("share_qr_label")} width=${width} height=${width} viewBox="0 0 ${size} ${size}" shape-rendering="crispEdges">
				<rect width=${size} height=${size} fill="#fff"/><path fill="#000" d=${qrPath(code)}/>
			</svg>
			<p>${text("share_qr_about")}</p>
			<div class="choices">
				<button class="button" type="button" @click=${() => save(qrSvg(code), "svg")}>${text("share_qr_svg")}</button>
				<button class="button" type="button" @click=${() => save(qrPng(code), "png")}>${text("share_qr_png")}</button>
			</div>
			${this.#resultOf("qr")}`;
	}

	/** Renders the preview of the picture, with its options. */
	#picture(shared: Shared): unknown {
		return html`<canvas class="preview" ?data-alone=${this.#alone} width="0" height="0" aria-hidden="true"></canvas>
			<label class="toggle">
				<input type="checkbox" .checked=${this.#alone} @change=${this.#chooseBackground}> ${text("share_picture_transparent")}
			</label>
			<div class="choices">
				<button class="button" type="button" @click=${this.#copyPicture}>${text("share_picture_copy")}</button>
				<button class="button" type="button" @click=${() => this.#savePicture(shared)}>${text("share_picture_download")}</button>
			</div>
			${this.#resultOf("picture")}`;
	}

	/**
	 * Opens the sheet for the plant on the controls, with the focus on the button that copies its link; the browser traps
	 * and restores the focus.
	 */
	async open(): Promise<void> {
		const { context } = this;
		restTools(context);
		const { model, specimen, fault, modelUi } = context.state;
		const link = await linkOf(model, specimen);
		this.#shared = {
			link,
			title: titleOf(specimen, model, modelUi?.tools),
			name: fileName(specimen, isAltered(specimen, model, modelUi?.tools)),
			remarks: [
				...(fault ? [text("link_has_error")] : []),
				...notInLink(model, specimen),
				...(model.preview ? [text("preview_remark")] : []),
			],
			code: qrModules(link),
		};
		this.#result = undefined;
		this.requestUpdate();
		await this.updateComplete;
		const dialog = this.querySelector("dialog");
		if (!dialog?.open) dialog?.showModal();
		this.querySelector<HTMLElement>("[data-copy]")?.focus();
		void this.#drawPreview();
	}

	/** Empties the sheet after it has been closed. */
	#closed(): void {
		this.#shared = undefined;
		this.#result = undefined;
		this.requestUpdate();
	}

	/** Shows and announces the result of an action in place of the last one. */
	#report(part: SharePart, words: string): void {
		this.#result = { part, words };
		this.requestUpdate();
	}

	/** Copies the link; if the clipboard is denied, selects the link for copying by hand. */
	async #copyLink({ link }: Shared): Promise<void> {
		try {
			await navigator.clipboard.writeText(link);
			this.#report("link", text("link_copied"));
		} catch {
			this.querySelector<HTMLElement>(".link input")?.focus();
			this.#report("link", text("copy_link_blocked"));
		}
	}

	/** Opens the system's dialog that sends the link to another app. */
	async #shareWith({ link, title }: Shared): Promise<void> {
		try {
			await navigator.share({ title, url: link });
			this.#report("link", text("share_done"));
		} catch (error) {
			// The user has closed the dialog.
			if (error instanceof DOMException && error.name === "AbortError") return;
			this.#report(
				"link",
				text("share_with_failed", { problem: error instanceof Error ? error.message : String(error) }),
			);
		}
	}

	/** Chooses between a picture with background and one without. */
	#chooseBackground({ target }: Event): void {
		this.#alone = (target as HTMLInputElement).checked;
		this.requestUpdate();
		void this.#drawPreview();
	}

	/** Draws a small picture of the view; without one the sheet has no preview. */
	async #drawPreview(): Promise<void> {
		const alone = this.#alone;
		const taken = this.context.state.picture?.({ height: PREVIEW_HEIGHT, alone });
		const bitmap = await taken?.then(createImageBitmap).catch(() => undefined);
		const canvas = this.querySelector<HTMLCanvasElement>("canvas.preview");
		if (!bitmap || !canvas || alone !== this.#alone) return;
		canvas.width = bitmap.width;
		canvas.height = bitmap.height;
		canvas.getContext("2d")?.drawImage(bitmap, 0, 0);
		bitmap.close();
	}

	/** Copies the picture and reports the result. */
	async #copyPicture(): Promise<void> {
		this.#report("picture", await copyPicture(this.context, { alone: this.#alone }));
	}

	/** Saves the picture as a file and reports the result. */
	async #savePicture({ name }: Shared): Promise<void> {
		try {
			this.#save(
				"picture",
				await pictureOf(this.context, { alone: this.#alone }),
				`${name}${this.#alone ? "-cut-out" : ""}.png`,
			);
		} catch (error) {
			const problem = error instanceof Error ? error.message : String(error);
			this.#report("picture", text("share_picture_failed", { problem }));
		}
	}

	/** Saves a file and reports that. */
	#save(part: SharePart, blob: Blob, file: string): void {
		saveFile(blob, file);
		this.#report(part, text("download_done", { file }));
	}

	/** Opens the dialog of the embed code in place of the sheet. */
	#embed(): void {
		this.querySelector("dialog")?.close();
		void openPart(this.context, EMBED);
	}
}

/** Returns whether the browser can send a link to other apps. */
const canShare = () => typeof navigator.share === "function";

/** Selects the text of a field that has received the focus. */
const selectAll = ({ target }: Event) => (target as HTMLInputElement).select();

customElements.define("panicle-share-sheet", ShareSheet);
