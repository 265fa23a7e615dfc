/**
 * `<panicle-specimen preset="long-conical" seed="7" age="80">`: a live plant in any page (docs/element.md). Attributes
 * are the model's parameters by their keys, or a link; unusable ones are reported in `notes`, and a plant grows with
 * defaults.
 */
import { Client } from "../core/client";
import { coreAddress } from "../core/core_address";
import { Superseded } from "../core/errors";
import type { FileOptions } from "../formats/file_options";
import { withLink } from "../formats/png_link";
import { plantInWords } from "../generate/plant_in_words";
import { MessageError, messageOf } from "../locale/message_error";
import type { GrowthOptions } from "../models/model";
import type { Plant } from "../plant/plant";
import { encodeLink } from "../specimen/link";
import { restore } from "../specimen/restore";
import type { Specimen } from "../specimen/specimen";
import { type WrittenSpecimen, writtenSpecimen } from "../specimen/written";
import { appAddress } from "./app_address";
import { isSpecimenAttribute, readAttributes } from "./attributes";
import { commons } from "./commons";
import { CurrentDocument } from "./current_document";
import { ElementExtras } from "./extras/extras";
import { growDocument } from "./grow_document";
import {
	changedIn,
	detailOf,
	documentFrom,
	type GrownDetail,
	type GrownDocument,
	type SpecimenDocument,
} from "./grown_detail";
import { text } from "./messages.generated";
import { loadPageLanguage } from "./page_language";
import { isDark, type Presence, watchPresence } from "./presence";
import { shadowTree } from "./shadow_tree";
import { SpecimenView } from "./specimen_view";

/** The custom element: its properties, methods and events for a page's scripts. */
export class PanicleSpecimen extends HTMLElement {
	readonly #canvas: HTMLCanvasElement;
	readonly #poster: HTMLImageElement;
	readonly #message: HTMLElement;
	readonly #describe: () => void;
	readonly #document = new CurrentDocument(async () => {
		await loadPageLanguage(this);
		this.#describe();
		const reading = await readAttributes(this.attributes);
		return documentFrom(reading.model, reading);
	});
	#shown: GrownDocument | undefined;
	/** Aborted when the element leaves the page; undefined while it is on no page. */
	#life: AbortController | undefined;
	#client: Client | undefined;
	#view: Promise<SpecimenView> | undefined;
	#near = false;
	#seen = false;
	/** Number of the newest growth; only the newest clears `aria-busy`. */
	#turn = 0;
	/** Whether a growth is due as soon as the element is near the viewport. */
	#due = false;
	#growing: Promise<GrownDetail> | undefined;
	readonly #attributes = new MutationObserver((changes) => this.#changed(namesOf(changes)));
	readonly #extras: ElementExtras;

	/** Builds the shadow tree and observes attributes; the plant is grown once the element is in a page. */
	constructor() {
		super();
		const { root, canvas, poster, message, describe } = shadowTree(this);
		this.#describe = describe;
		this.#canvas = canvas;
		this.#poster = poster;
		this.#message = message;
		this.#extras = new ElementExtras({
			element: this,
			root,
			interaction: {
				edit: (change) => {
					this.#changeDocument((document) => changedIn(document, change), { preview: true }).catch(() => {});
				},
				settle: () => void this.#changeDocument((document) => document).catch(() => {}),
			},
			view: () => this.#loadView(),
		});
		// Observe attributes also while the element is on no page.
		this.#attributes.observe(this, { attributes: true });
		this.#updateLabel();
	}

	/** The specimen in view, in the form of the JSON format; undefined until a plant has grown. */
	get specimen(): WrittenSpecimen<Specimen> | undefined {
		return this.#shown && writtenSpecimen(this.#shown.model, this.#shown.specimen);
	}

	/** The plant in view; undefined until one has grown. */
	get plant(): Plant | undefined {
		return this.#shown?.grown;
	}

	/** Notes about attributes that could not be used, and notes of the core. */
	get notes(): readonly string[] {
		return this.#shown ? [...this.#shown.notes, ...this.#shown.grown.notes] : [];
	}

	/** Changes parameters, seed or look by their keys, in one step; dispatches `change` and then `grown`. */
	set(values: Readonly<Record<string, number | string>>): Promise<GrownDetail> {
		return this.#changeDocument(({ model, specimen: before }) => documentFrom(model, restore(model, values, before)));
	}

	/** Grows the current document now, even if the element is far from the viewport. */
	grow(): Promise<GrownDetail> {
		this.#flush();
		return this.#begin({});
	}

	/** A file of the plant, by the key of its format: `glb`, `glb-web`, `usdz`, `obj` (a ZIP), `json`, … */
	async toFile(format: string, options: FileOptions = {}): Promise<Blob> {
		const { model, specimen, grown } = await this.#settledPlant();
		const { exportFile } = await import("../generate/files/exporter");
		const link = await encodeLink(model, specimen);
		const core = coreAddress(model.wasm);
		const name = specimen.preset;
		const request = { model: model.name, format, grown, specimen, link, name, options, ...(core ? { core } : {}) };
		return exportFile(model, request);
	}

	/** The current view as a PNG; by default twice the element's size in CSS pixels. */
	async toBlob({ width = 2 * this.clientWidth, height = 2 * this.clientHeight } = {}): Promise<Blob> {
		const { model, specimen } = await this.#settledPlant();
		const picture = await (await this.#loadView()).picture(width, height);
		return withLink(picture, `${appAddress(this.getAttribute("app")) ?? ""}${await encodeLink(model, specimen)}`);
	}

	/** Resets the camera: the whole plant, from the initial direction. */
	resetView(): void {
		this.#view?.then((view) => view.reset()).catch(() => {});
	}

	/** Called by the browser when the element is inserted into a page. */
	connectedCallback(): void {
		const life = new AbortController();
		this.#life = life;
		const leave = commons.enter();
		this.#client = new Client();
		const presence: Presence = {
			resized: () => this.#withView((view) => view.resize()),
			near: (near) => {
				this.#near = near;
				if (near && this.#due) this.#requestGrowth();
			},
			seen: (seen) => {
				this.#seen = seen;
				this.#withView((view) => view.setSeen(seen));
			},
			darkened: () => this.#follow("theme"),
		};
		watchPresence(this, presence, life.signal);
		life.signal.addEventListener("abort", () => {
			this.#client?.close();
			this.#extras.close();
			this.#view?.then((view) => view.dispose()).catch(() => {});
			this.#view = undefined;
			leave();
		});
		this.#follow("poster");
		this.#requestGrowth();
	}

	/** Called by the browser when the element is removed from its page. */
	disconnectedCallback(): void {
		this.#life?.abort();
		this.#life = undefined;
	}

	/** Processes attribute changes of the current task, which the observer would report only later. */
	#flush(): void {
		this.#changed(namesOf(this.#attributes.takeRecords()));
	}

	#changed(names: readonly string[]): void {
		for (const name of names) this.#follow(name);
		if (!names.some(isSpecimenAttribute)) return;
		this.#document.forget();
		this.#requestGrowth();
	}

	/** Applies an attribute about display. */
	#follow(name: string): void {
		if (name === "poster") {
			const address = this.getAttribute("poster");
			if (address !== null && !this.#shown) this.#poster.src = address;
			else this.#poster.removeAttribute("src");
		} else if (name === "alt") this.#updateLabel();
		else if (name === "theme") this.#withView((view) => view.setDark(isDark(this.getAttribute("theme"))));
		else if (name === "autorotate") this.#withView((view) => view.setTurning(this.getAttribute("autorotate")));
		else if (name === "wind") this.#withView((view) => view.setWind(this.getAttribute("wind")));
		else if (name === "outdoors") this.#withView((view) => view.setOutdoors(this.hasAttribute("outdoors")));
		this.#extras.follow();
	}

	/** Changes the document and grows it. Dispatches `input` during a drag (`preview`), otherwise `change`. */
	async #changeDocument(
		make: (before: SpecimenDocument) => SpecimenDocument,
		{ preview = false } = {},
	): Promise<GrownDetail> {
		this.#flush();
		const { model, specimen } = await this.#document.change(make);
		const detail = { link: await encodeLink(model, specimen) };
		this.dispatchEvent(new CustomEvent(preview ? "input" : "change", { detail, bubbles: true }));
		this.#withView((view) => view.hold(preview));
		return this.#begin({ preview });
	}

	/**
	 * Starts a growth in place of a due one; its promise may also be ignored, because its failure is reported elsewhere.
	 */
	#begin(options: GrowthOptions): Promise<GrownDetail> {
		this.#due = false;
		this.#growing = this.#grow(options);
		this.#growing.catch(() => {});
		return this.#growing;
	}

	/** Schedules a growth; with `loading="lazy"` once the element is near the viewport. */
	#requestGrowth(): void {
		if (!this.#life) return;
		this.#due = true;
		const lazy = this.getAttribute("loading") === "lazy";
		if (!lazy || this.#near) queueMicrotask(() => this.#due && this.#life && void this.grow().catch(() => {}));
	}

	/** Grows the current document and shows it. An older growth that a newer one overtakes rejects with Superseded. */
	async #grow(options: GrowthOptions): Promise<GrownDetail> {
		const life = this.#life;
		const client = this.#client;
		if (!life || !client) throw new MessageError(text.message("not_in_page"));
		const turn = ++this.#turn;
		this.setAttribute("aria-busy", "true");
		try {
			const document = await this.#document.get();
			const grown = await growDocument(client, document, options, life.signal, () => turn === this.#turn);
			const shown: GrownDocument = { ...document, grown };
			await this.#show(shown);
			const detail = await detailOf(shown);
			this.dispatchEvent(new CustomEvent<GrownDetail>("grown", { detail, bubbles: true }));
			return detail;
		} catch (error) {
			if (!life.signal.aborted && !(error instanceof Superseded)) this.#fail(error);
			throw error;
		} finally {
			if (turn === this.#turn) this.removeAttribute("aria-busy");
		}
	}

	/** Draws a plant; the controls follow only if it is still the newest one. */
	async #show(shown: GrownDocument): Promise<void> {
		this.#shown = shown;
		this.#message.hidden = true;
		this.#updateLabel();
		const view = await this.#loadView().catch((error: unknown) => this.#fail(error));
		await view?.show(shown.model, shown.grown, shown.specimen);
		// An older plant would reset controls that the user has moved since.
		const newest = await this.#document.get().catch(() => undefined);
		if (view && this.#view && newest?.specimen === shown.specimen) this.#extras.show(shown);
	}

	/** The view, created on first use. */
	#loadView(): Promise<SpecimenView> {
		if (this.#view) return this.#view;
		const life = this.#life;
		if (!life) return Promise.reject(new MessageError(text.message("not_in_page")));
		const view = SpecimenView.create(this.#canvas, commons, { drawn: () => this.#poster.removeAttribute("src") });
		this.#view = view;
		view.then(
			(made) => {
				if (life.signal.aborted) return made.dispose();
				made.setDark(isDark(this.getAttribute("theme")));
				made.setTurning(this.getAttribute("autorotate"));
				made.setWind(this.getAttribute("wind"));
				made.setOutdoors(this.hasAttribute("outdoors"));
				made.setSeen(this.#seen);
			},
			() => {
				if (this.#view === view) this.#view = undefined;
			},
		);
		return view;
	}

	#withView(work: (view: SpecimenView) => void): void {
		void this.#view?.then(work, () => {});
	}

	/** The plant of the current document, once it has grown. */
	async #settledPlant(): Promise<GrownDocument> {
		this.#flush();
		if (this.#due) this.grow();
		await this.#growing;
		if (!this.#shown) throw new MessageError(text.message("not_grown"));
		return this.#shown;
	}

	/** Shows an error and dispatches `error`; the last plant stays in view. */
	#fail(error: unknown): void {
		const { code, args, text: message } = messageOf(error);
		this.#message.textContent = message;
		this.#message.hidden = false;
		this.dispatchEvent(new CustomEvent("error", { detail: { message, code, args } }));
	}

	/** Updates the view's text alternative. */
	#updateLabel(): void {
		const words = this.#shown && plantInWords(this.#shown);
		this.#canvas.setAttribute("aria-label", this.getAttribute("alt") ?? words ?? text("growing"));
	}
}

const namesOf = (changes: readonly MutationRecord[]) => changes.map(({ attributeName }) => attributeName ?? "");
