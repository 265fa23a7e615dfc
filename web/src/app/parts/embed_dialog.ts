import { html, nothing, type TemplateResult } from "lit";
import { keyed } from "lit/directives/keyed.js";
import { plantInWords } from "../../generate/plant_in_words";
import { encodeLink } from "../../specimen/link";
import { saveFile } from "../../ui/save_file";
import { notInLink } from "../address";
import {
	type EmbedChoice,
	type Embedded,
	type EmbedForm,
	embedCode,
	frameAddress,
	LONGEST_SIDE,
} from "../files/embed_code";
import { type DownloadFormat, type DownloadRequest, downloadFormats, fileName } from "../files/formats";
import { downloadRequestFor, sizeInWords } from "../files/made_ahead";
import { type PageWeight, pageWeight } from "../files/page_weight";
import { plantToSave } from "../files/plant_to_save";
import { text } from "../messages.generated";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";
import "../style/embed.css";

/** Greatest size of the preview, CSS pixels; larger frames are scaled down. */
const PREVIEW = { width: 300, height: 320 };

const FORMS: readonly { readonly form: EmbedForm; title(): string; about(): string }[] = [
	{ form: "element", title: () => text("embed_element"), about: () => text("embed_element_about") },
	{ form: "frame", title: () => text("embed_frame"), about: () => text("embed_frame_about") },
	{ form: "model-viewer", title: () => "<model-viewer>", about: () => text("embed_viewer_about") },
];

/** Keys of the formats that model-viewer opens. */
const FILES = ["glb-low", "glb"];

/** Options with a checkbox. */
type Switch = "autorotate" | "wind" | "controls" | "handles" | "lazy";

/** The plant that the dialog was opened for. */
interface Opened {
	readonly request: DownloadRequest;
	readonly of: Embedded;
	/** Parts of the specimen that the link does not hold, a sentence each. */
	readonly lost: readonly string[];
	readonly hasHandles: boolean;
	readonly sways: boolean;
}

/** The dialog with the embed code of a plant, a preview and its download size. */
export class EmbedDialog extends StudioPart {
	#choice: EmbedChoice = {
		form: "element",
		width: 300,
		height: 400,
		autorotate: false,
		wind: false,
		controls: true,
		handles: false,
		lazy: true,
	};
	#opened: Opened | undefined;
	#weight: PageWeight | undefined;
	/** The key of the file for model-viewer, and the file itself once it is made. */
	#format = FILES[0];
	#file: Blob | undefined;
	#making: AbortController | undefined;
	#failed = false;
	#message = "";

	/** Renders the dialog, empty while it is closed. */
	protected override draw(): unknown {
		return html`<dialog class="help many embed" aria-labelledby=${this.idOf("title")} @close=${this.#closed}>
			<h2 id=${this.idOf("title")}>${text("embed_title")}</h2>
			${this.#opened ? this.#body(this.#opened) : nothing}
		</dialog>`;
	}

	/** Opens the dialog for the plant on the controls; the browser traps the focus and restores it. */
	async open(): Promise<void> {
		this.#opened = await openedOn(this.context);
		this.#message = "";
		this.requestUpdate();
		await this.updateComplete;
		this.querySelector("dialog")?.showModal();
		void this.#make();
	}

	/**
	 * Renders the choices, a preview, and the code to copy.
	 * @param opened.lost the parts that the link does not contain
	 */
	#body({ of, lost, hasHandles, sways }: Opened): TemplateResult {
		const choice = this.#choice;
		const { form } = choice;
		const isFile = form === "model-viewer";
		const code = embedCode(of, choice);
		return html`<div class="sides">
			<form @submit=${(event: Event) => event.preventDefault()}>
				<fieldset role="radiogroup" aria-label=${text("embed_form")} aria-describedby=${this.idOf("about")}>
					${FORMS.map(({ form: each, title }) => html`<label><input type="radio" name=${this.idOf("form")} .checked=${each === form} @change=${() => this.#choose({ form: each })}>${title()}</label>`)}
				</fieldset>
				<small id=${this.idOf("about")}>${FORMS.find((each) => each.form === form)?.about()}</small>
				<fieldset class="size" aria-label=${text("embed_size")}><span aria-hidden="true">${text("embed_size")}</span>${text.pieces("embed_sides", { width: this.#side("width", text("embed_width")), height: this.#side("height", text("embed_height")) })}</fieldset>
				<fieldset>
					${this.#switch("autorotate", text("embed_autorotate"))}
					${isFile || !sways ? nothing : this.#switch("wind", text("embed_wind"))}
					${this.#switch("controls", text(isFile ? "embed_viewer_controls" : "embed_controls"))}
					${isFile || !hasHandles ? nothing : this.#switch("handles", text("embed_handles"))}
					${this.#switch("lazy", text("embed_lazy"))}
				</fieldset>
				${isFile ? this.#files() : nothing}
			</form>
			${this.#preview(of)}
		</div>
		<textarea readonly rows="5" aria-label=${text("embed_code")} spellcheck="false" .value=${code} @focus=${(event: FocusEvent) => (event.target as HTMLTextAreaElement).select()}></textarea>
		<p class="weight">${this.#weightInWords()}</p>
		${remarks(of, isFile ? [] : lost, this.context).map((line) => html`<p><small>${line}</small></p>`)}
		<div class="choices">
			<p role="status">${this.#message}</p>
			<button class="button wine" type="button" @click=${() => this.#copy(code)}>${text("embed_copy")}</button>
			<button class="button quiet" type="button" @click=${() => this.querySelector("dialog")?.close()}>${text("close")}</button>
		</div>`;
	}

	/** Renders the field for width or height. */
	#side(side: "width" | "height", label: string): TemplateResult {
		return html`<input
			type="number" aria-label=${label} min="1" max=${LONGEST_SIDE} step="1" required .value=${String(this.#choice[side])}
			@input=${({ target }: Event) => {
				const { value, validity } = target as HTMLInputElement;
				if (validity.valid) this.#choose({ [side]: Number(value) });
			}}
		>`;
	}

	/** Renders the checkbox of an option. */
	#switch(key: Switch, label: string): TemplateResult {
		return html`<label class="toggle"><input
			type="checkbox" .checked=${this.#choice[key]} @change=${({ target }: Event) => this.#choose({ [key]: (target as HTMLInputElement).checked })}
		> ${label}</label>`;
	}

	/** Renders the choice of the file for the `model-viewer` form, and a button that saves it. */
	#files(): TemplateResult {
		const { request } = this.#opened as Opened;
		const formats = filesOf(request);
		return html`<label>${text("embed_file")} <select @change=${({ target }: Event) => this.#chooseFile((target as HTMLSelectElement).value)}>
				${formats.map(({ key, title }) => html`<option value=${key} ?selected=${key === this.#format}>${title}</option>`)}
			</select></label>
			<button class="button" type="button" ?disabled=${!this.#file} @click=${() => this.#file && saveFile(this.#file, `${request.name}.glb`)}>
				${text("embed_download", { file: `${request.name}.glb` })}
			</button>`;
	}

	/** Renders a live preview of the frame. */
	#preview(of: Embedded): TemplateResult {
		const { form, width, height, autorotate } = this.#choice;
		// A new address gets a new frame: navigating the old one would add a history entry.
		const address = frameAddress(of, form === "model-viewer" ? { autorotate } : this.#choice);
		return html`<figure>
			<div class="preview">${keyed(address, html`<iframe title=${text("embed_preview")} src=${address} width=${width} height=${height} @load=${this.#loaded}></iframe>`)}</div>
			<figcaption>${text(form === "model-viewer" ? "embed_viewer_preview" : "embed_preview")}</figcaption>
		</figure>`;
	}

	/** Scales the preview to fit. */
	protected override updated(): void {
		const frame = this.querySelector<HTMLElement>("iframe");
		if (!frame?.parentElement) return;
		const { width, height } = this.#choice;
		const scale = Math.min(1, PREVIEW.width / width, PREVIEW.height / height);
		frame.style.transform = `scale(${scale})`;
		frame.parentElement.style.width = `${width * scale}px`;
		frame.parentElement.style.height = `${height * scale}px`;
	}

	/** Changes options; the form for model-viewer needs a file, which is then made. */
	#choose(changed: Partial<EmbedChoice>): void {
		this.#choice = { ...this.#choice, ...changed };
		this.#message = "";
		this.requestUpdate();
		if (changed.form) void this.#make();
	}

	/** Chooses the format of the file for model-viewer and makes that file. */
	#chooseFile(format: string): void {
		this.#format = format;
		this.#file = undefined;
		void this.#make();
	}

	/** Sums the size of the files that the preview fetches, again after later fetches. */
	readonly #loaded = ({ target }: Event): void => {
		const { contentWindow: page } = target as HTMLIFrameElement;
		if (!page) return;
		const { performance, PerformanceObserver } = page as Window & typeof globalThis;
		const weigh = async () => {
			const addresses = performance.getEntriesByType("resource").map(({ name }) => name);
			const weight = await pageWeight([...addresses, page.location.href.replace(/[?#].*/, "")], location.origin);
			if (!(target as Node).isConnected) return;
			this.#weight = weight;
			this.requestUpdate();
		};
		new PerformanceObserver(() => void weigh()).observe({ type: "resource", buffered: true });
	};

	/** Describes how many bytes the plant adds to a page; empty where its file could not be made. */
	#weightInWords(): string {
		if (this.#choice.form === "model-viewer" && this.#failed) return "";
		if (this.#choice.form === "model-viewer")
			return this.#file ? text("embed_viewer_adds", { size: sizeInWords(this.#file.size) }) : text("embed_preparing");
		const { scripts, cores } = this.#weight ?? { scripts: 0, cores: 0 };
		return cores === 0 ? text("embed_measuring") : text("embed_adds", { size: sizeInWords(scripts + cores) });
	}

	/** Makes the GLB, if the form needs it and it is missing. */
	async #make(): Promise<void> {
		const opened = this.#opened;
		if (!opened || this.#file || this.#choice.form !== "model-viewer") return;
		this.#making?.abort();
		const making = new AbortController();
		this.#making = making;
		const format = filesOf(opened.request).find(({ key }) => key === this.#format);
		this.#failed = false;
		try {
			const file = await format?.make(opened.request, making.signal);
			if (!making.signal.aborted) this.#file = file;
		} catch (error) {
			this.#failed = !making.signal.aborted;
			const problem = error instanceof Error ? error.message : String(error);
			if (this.#failed) this.#message = text("embed_file_failed", { problem });
		}
		this.requestUpdate();
	}

	/** Copies the code; if the clipboard is denied, selects the code for copying by hand. */
	async #copy(code: string): Promise<void> {
		try {
			await navigator.clipboard.writeText(code);
			this.#message = text("embed_copied");
		} catch {
			this.querySelector("textarea")?.focus();
			this.#message = text("embed_copy_blocked");
		}
		this.requestUpdate();
	}

	/** Clears the dialog's state, and with it the preview. */
	#closed(): void {
		this.#making?.abort();
		this.#opened = undefined;
		this.#file = undefined;
		this.#weight = undefined;
		this.requestUpdate();
	}
}

/** Collects what the dialog shows of the plant that is at rest when it opens. */
async function openedOn(studio: Studio): Promise<Opened> {
	const plant = await plantToSave(studio);
	const { model, from, grown } = plant;
	const name = fileName(from);
	const of: Embedded = {
		app: new URL("./", `${location.origin}${location.pathname}`).href,
		link: await encodeLink(model, from),
		description: plantInWords({ model, specimen: from, grown }),
		file: `${name}.glb`,
	};
	return {
		request: await downloadRequestFor(plant, name, {}),
		of,
		lost: notInLink(model, from),
		hasHandles: model.handles !== undefined,
		sways: model.still !== true,
	};
}

/** Returns the formats of the plant that model-viewer opens. */
const filesOf = ({ plant }: DownloadRequest): DownloadFormat[] =>
	downloadFormats(plant, undefined).filter(({ key }) => FILES.includes(key));

/**
 * Returns remarks for users of the code.
 * @param lost parts that the link does not contain, a sentence each
 */
function remarks({ app }: Embedded, lost: readonly string[], { state: { model } }: Studio): string[] {
	const { hostname } = new URL(app);
	const local = /^(localhost|127\.|\[::1\])/.test(hostname) ? [text("embed_local", { host: hostname })] : [];
	const preview = model.preview ? [text("preview_remark")] : [];
	return [...local, ...preview, ...lost];
}

customElements.define("panicle-embed", EmbedDialog);
