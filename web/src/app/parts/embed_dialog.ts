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
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";
import "../style/embed.css";

/** Greatest size of the preview, CSS pixels; larger frames are scaled down. */
const PREVIEW = { width: 300, height: 320 };

const FORMS: readonly { readonly form: EmbedForm; readonly title: string; readonly about: string }[] = [
	{ form: "element", title: "Element", about: "One script and one tag: for pages that may have scripts." },
	{ form: "frame", title: "Frame", about: "One tag: for places that allow frames alone." },
	{
		form: "model-viewer",
		title: "<model-viewer>",
		about: "A GLB beside your page, shown by Google’s viewer; it does not grow.",
	},
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

	protected override draw(): unknown {
		return html`<dialog class="help many embed" aria-labelledby=${this.idOf("title")} @close=${this.#closed}>
			<h2 id=${this.idOf("title")}>Copy embed code</h2>
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

	#body({ of, lost, hasHandles, sways }: Opened): TemplateResult {
		const choice = this.#choice;
		const { form } = choice;
		const isFile = form === "model-viewer";
		const code = embedCode(of, choice);
		return html`<div class="sides">
			<form @submit=${(event: Event) => event.preventDefault()}>
				<fieldset role="radiogroup" aria-label="Form" aria-describedby=${this.idOf("about")}>
					${FORMS.map(({ form: each, title }) => html`<label><input type="radio" name=${this.idOf("form")} .checked=${each === form} @change=${() => this.#choose({ form: each })}>${title}</label>`)}
				</fieldset>
				<small id=${this.idOf("about")}>${FORMS.find((each) => each.form === form)?.about}</small>
				<fieldset class="size" aria-label="Size"><span aria-hidden="true">Size</span>${this.#side("width", "Width")} × ${this.#side("height", "Height")} pixels</fieldset>
				<fieldset>
					${this.#switch("autorotate", "Turns by itself")}
					${isFile || !sways ? nothing : this.#switch("wind", "Sways in the wind")}
					${this.#switch("controls", isFile ? "Can be turned" : "Controls below it")}
					${isFile || !hasHandles ? nothing : this.#switch("handles", "Handles to drag")}
					${this.#switch("lazy", "Waits until it is near the screen")}
				</fieldset>
				${isFile ? this.#files() : nothing}
			</form>
			${this.#preview(of)}
		</div>
		<textarea readonly rows="5" aria-label="Code" spellcheck="false" .value=${code} @focus=${(event: FocusEvent) => (event.target as HTMLTextAreaElement).select()}></textarea>
		<p class="weight">${this.#weightInWords()}</p>
		${remarks(of, isFile ? [] : lost, this.context).map((line) => html`<p><small>${line}</small></p>`)}
		<div class="choices">
			<p role="status">${this.#message}</p>
			<button class="button wine" type="button" @click=${() => this.#copy(code)}>Copy code</button>
			<button class="button quiet" type="button" @click=${() => this.querySelector("dialog")?.close()}>Close</button>
		</div>`;
	}

	#side(side: "width" | "height", label: string): TemplateResult {
		return html`<input
			type="number" aria-label=${label} min="1" max=${LONGEST_SIDE} step="1" required .value=${String(this.#choice[side])}
			@input=${({ target }: Event) => {
				const { value, validity } = target as HTMLInputElement;
				if (validity.valid) this.#choose({ [side]: Number(value) });
			}}
		>`;
	}

	#switch(key: Switch, words: string): TemplateResult {
		return html`<label class="toggle"><input
			type="checkbox" .checked=${this.#choice[key]} @change=${({ target }: Event) => this.#choose({ [key]: (target as HTMLInputElement).checked })}
		> ${words}</label>`;
	}

	#files(): TemplateResult {
		const { request } = this.#opened as Opened;
		const formats = filesOf(request);
		return html`<label>File <select @change=${({ target }: Event) => this.#chooseFile((target as HTMLSelectElement).value)}>
				${formats.map(({ key, title }) => html`<option value=${key} ?selected=${key === this.#format}>${title}</option>`)}
			</select></label>
			<button class="button" type="button" ?disabled=${!this.#file} @click=${() => this.#file && saveFile(this.#file, `${request.name}.glb`)}>
				Download ${request.name}.glb
			</button>`;
	}

	/** A live preview of the frame, scaled to fit. */
	#preview(of: Embedded): TemplateResult {
		const { form, width, height, autorotate } = this.#choice;
		// A new address gets a new frame: navigating the old one would add a history entry.
		const address = frameAddress(of, form === "model-viewer" ? { autorotate } : this.#choice);
		return html`<figure>
			<div class="preview">${keyed(address, html`<iframe title="Preview" src=${address} width=${width} height=${height} @load=${this.#loaded}></iframe>`)}</div>
			<figcaption>${form === "model-viewer" ? "The same plant; model-viewer has a light of its own" : "As it will be"}</figcaption>
		</figure>`;
	}

	protected override updated(): void {
		const frame = this.querySelector<HTMLElement>("iframe");
		if (!frame?.parentElement) return;
		const { width, height } = this.#choice;
		const scale = Math.min(1, PREVIEW.width / width, PREVIEW.height / height);
		frame.style.transform = `scale(${scale})`;
		frame.parentElement.style.width = `${width * scale}px`;
		frame.parentElement.style.height = `${height * scale}px`;
	}

	#choose(changed: Partial<EmbedChoice>): void {
		this.#choice = { ...this.#choice, ...changed };
		this.#message = "";
		this.requestUpdate();
		if (changed.form) void this.#make();
	}

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

	#weightInWords(): string {
		if (this.#choice.form === "model-viewer" && this.#failed) return "";
		if (this.#choice.form === "model-viewer")
			return this.#file
				? `A visitor downloads the GLB of ${sizeInWords(this.#file.size)}, and model-viewer itself.`
				: "The GLB is being made.";
		const { scripts, cores } = this.#weight ?? { scripts: 0, cores: 0 };
		if (cores === 0) return "What a visitor downloads is being counted.";
		return `A visitor downloads ${sizeInWords(scripts + cores)} packed, once for all plants of a page: ${sizeInWords(scripts)} of scripts and ${sizeInWords(cores)} of core.`;
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
			if (this.#failed) this.#message = `The GLB could not be made: ${error instanceof Error ? error.message : error}`;
		}
		this.requestUpdate();
	}

	/** Copies the code; if the clipboard is denied, selects the code for copying by hand. */
	async #copy(code: string): Promise<void> {
		try {
			await navigator.clipboard.writeText(code);
			this.#message = "Copied";
		} catch {
			this.querySelector("textarea")?.focus();
			this.#message = "The browser did not let the page copy; the code is selected, copy it by hand.";
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

async function openedOn(studio: Studio): Promise<Opened> {
	const plant = await plantToSave(studio);
	const { model, from, grown } = plant;
	const name = fileName(from);
	const of: Embedded = {
		app: new URL("./", `${location.origin}${location.pathname}`).href,
		link: await encodeLink(model, from),
		words: plantInWords({ model, specimen: from, grown }),
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

const filesOf = ({ plant }: DownloadRequest): DownloadFormat[] =>
	downloadFormats(plant, undefined).filter(({ key }) => FILES.includes(key));

/** Remarks for the user who copies the code. */
function remarks({ app }: Embedded, lost: readonly string[], { state: { model } }: Studio): string[] {
	const { hostname } = new URL(app);
	const local = /^(localhost|127\.|\[::1\])/.test(hostname)
		? [`The code names ${hostname}, which nobody else can reach: put the app on a host, and copy it there.`]
		: [];
	const preview = model.preview ? [`The ${model.noun} is a preview: what its links mean may still change.`] : [];
	return [...local, ...preview, ...lost];
}

customElements.define("panicle-embed", EmbedDialog);
