/**
 * `<panicle-specimen preset="long-conical" seed="7" age="80">`: a living plant in any page (docs/element.md). Attributes are the model's
 * parameters by their keys, or a link; what is wrong in them is told in `notes`, and a plant grows all the same.
 */
import type { Client } from "../core/client";
import { coreAddress } from "../core/core_address";
import { Superseded } from "../core/errors";
import type { FileOptions } from "../export/plant_files";
import type { Plant } from "../plant/plant";
import { encodeLink } from "../specimen/link";
import { restore } from "../specimen/restore";
import type { Specimen } from "../specimen/specimen";
import { type WrittenSpecimen, writtenSpecimen } from "../specimen/written";
import { readAttributes, saysSpecimen } from "./attributes";
import { commons } from "./commons";
import { type Document, detailOf, type GrownDetail, type Shown } from "./grown_detail";
import { shadowTree } from "./shadow_tree";
import { SpecimenView } from "./specimen_view";

/** How far off screen a lazy plant begins to grow. */
const NEAR = "256px";
const ON_NO_PAGE = "The plant is on no page; append it first.";

export class PanicleSpecimen extends HTMLElement {
	readonly #canvas: HTMLCanvasElement;
	readonly #poster: HTMLImageElement;
	readonly #message: HTMLElement;
	#document: Promise<Document> | undefined;
	#shown: Shown | undefined;
	/** From when it comes to a page until it leaves. */
	#life: AbortController | undefined;
	#client: Client | undefined;
	#view: Promise<SpecimenView> | undefined;
	#near = false;
	#seen = false;
	/** The newest growth: only that ends being busy. */
	#turn = 0;
	/** Whether a growth is due as soon as the plant comes near. */
	#due = false;
	#growing: Promise<GrownDetail> | undefined;
	readonly #attributes = new MutationObserver((changes) => this.#changed(namesOf(changes)));

	constructor() {
		super();
		const { canvas, poster, message } = shadowTree(this);
		this.#canvas = canvas;
		this.#poster = poster;
		this.#message = message;
		// For as long as there is the element: what changes while it is on no page counts, too.
		this.#attributes.observe(this, { attributes: true });
		this.#say();
	}

	/** What is grown, as JSON has it; undefined until the attributes have been read. */
	get specimen(): WrittenSpecimen<Specimen> | undefined {
		return this.#shown && writtenSpecimen(this.#shown.model, this.#shown.specimen);
	}

	/** The plant on screen; undefined until there is one. */
	get plant(): Plant | undefined {
		return this.#shown?.grown;
	}

	/** What of the attributes could not be used, and what the core had to say. */
	get notes(): readonly string[] {
		return this.#shown ? [...this.#shown.notes, ...this.#shown.grown.notes] : [];
	}

	/** Changes parameters, seed or look by their keys, as one change: `change` and then `grown` follow. */
	async set(values: Readonly<Record<string, number | string>>): Promise<GrownDetail> {
		this.#flush();
		const document = this.#read().then(({ model, specimen: before }): Document => {
			const { specimen, notes } = restore(model, values, before);
			return { model, specimen, notes: notes.map(({ text }) => text) };
		});
		this.#document = document;
		const { model, specimen } = await document;
		const detail = { link: await encodeLink(model, specimen) };
		this.dispatchEvent(new CustomEvent("change", { detail, bubbles: true }));
		return this.grow();
	}

	/** Grows now, wherever it is, what has not grown yet. */
	grow(): Promise<GrownDetail> {
		this.#flush();
		this.#due = false;
		const growing = this.#grow();
		this.#growing = growing;
		growing.catch(() => {});
		return growing;
	}

	/** A file of the plant, by the key of its kind: `glb`, `glb-web`, `usdz`, `obj` (a ZIP), `json`, … */
	async toFile(format: string, options: FileOptions = {}): Promise<Blob> {
		const { model, specimen, grown } = await this.#whole();
		const { exportFile } = await import("../files/exporter");
		const link = await encodeLink(model, specimen);
		const core = coreAddress(model.wasm);
		const name = specimen.preset;
		const request = { model: model.name, format, grown, specimen, link, name, options, ...(core ? { core } : {}) };
		return exportFile(model, request);
	}

	/** The present view as a PNG; as large as the element, twice as fine, where nobody says. */
	async toBlob({ width = 2 * this.clientWidth, height = 2 * this.clientHeight } = {}): Promise<Blob> {
		await this.#whole();
		return (await this.#viewed()).picture(width, height);
	}

	/** The whole plant, from the direction in which it is first seen. */
	resetView(): void {
		this.#view?.then((view) => view.reset()).catch(() => {});
	}

	connectedCallback(): void {
		const life = new AbortController();
		this.#life = life;
		const leave = commons.enter();
		this.#client = commons.client();
		const sizes = new ResizeObserver(() => this.#withView((view) => view.resize()));
		sizes.observe(this);
		const near = new IntersectionObserver((entries) => this.#approach(entries), { rootMargin: NEAR });
		const seen = new IntersectionObserver((entries) => {
			this.#seen = isSeen(entries);
			this.#withView((view) => view.setSeen(this.#seen));
		});
		for (const observer of [near, seen]) observer.observe(this);
		const dark = matchMedia("(prefers-color-scheme: dark)");
		dark.addEventListener("change", () => this.#follow("theme"), { signal: life.signal });
		life.signal.addEventListener("abort", () => {
			for (const observer of [sizes, near, seen]) observer.disconnect();
			this.#client?.close();
			this.#view?.then((view) => view.dispose()).catch(() => {});
			this.#view = undefined;
			leave();
		});
		this.#follow("poster");
		this.#ask();
	}

	disconnectedCallback(): void {
		this.#life?.abort();
		this.#life = undefined;
	}

	/** An attribute that was set just now is not told before the present task is through. */
	#flush(): void {
		this.#changed(namesOf(this.#attributes.takeRecords()));
	}

	#changed(names: readonly string[]): void {
		for (const name of names) this.#follow(name);
		if (!names.some(saysSpecimen)) return;
		this.#document = undefined;
		this.#ask();
	}

	/** An attribute that changes what is done with the plant. */
	#follow(name: string): void {
		if (name === "poster") {
			const address = this.getAttribute("poster");
			if (address !== null && !this.#shown) this.#poster.src = address;
			else this.#poster.removeAttribute("src");
		} else if (name === "alt") this.#say();
		else if (name === "theme") this.#withView((view) => view.setDark(this.#isDark()));
		else if (name === "autorotate") this.#withView((view) => view.setTurning(this.getAttribute("autorotate")));
	}

	/** Grows as soon as it may. */
	#ask(): void {
		if (!this.#life) return;
		this.#due = true;
		const lazy = this.getAttribute("loading") === "lazy";
		if (!lazy || this.#near) queueMicrotask(() => this.#due && this.#life && void this.grow().catch(() => {}));
	}

	#approach(entries: readonly IntersectionObserverEntry[]): void {
		this.#near = isSeen(entries);
		if (this.#near && this.#due) this.#ask();
	}

	#read(): Promise<Document> {
		this.#document ??= readAttributes(this.attributes).then(({ model, specimen, notes }) => ({
			model,
			specimen,
			notes: notes.map(({ text }) => text),
		}));
		return this.#document;
	}

	async #grow(): Promise<GrownDetail> {
		const life = this.#life;
		const client = this.#client;
		if (!life || !client) throw new Error(ON_NO_PAGE);
		const turn = ++this.#turn;
		this.setAttribute("aria-busy", "true");
		try {
			const document = await this.#read();
			const { model, specimen } = document;
			await model.prepare?.(specimen)?.catch(() => {});
			const wasm = coreAddress(model.wasm);
			if (wasm === undefined) throw new Error(`The core of the ${model.noun} is not beside the script.`);
			const answer = await client.grow({ wasm, blocks: model.encode(specimen) }, { signal: life.signal });
			const shown: Shown = { ...document, grown: model.read(answer, specimen) };
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

	async #show(shown: Shown): Promise<void> {
		this.#shown = shown;
		this.#message.hidden = true;
		this.#say();
		const view = await this.#viewed().catch((error: unknown) => this.#fail(error));
		await view?.show(shown.model, shown.grown, shown.specimen);
	}

	/** The view, made when it is first needed. */
	#viewed(): Promise<SpecimenView> {
		if (this.#view) return this.#view;
		const life = this.#life;
		if (!life) return Promise.reject(new Error(ON_NO_PAGE));
		const view = SpecimenView.create(this.#canvas, commons, { drawn: () => this.#poster.removeAttribute("src") });
		this.#view = view;
		view.then(
			(made) => {
				if (life.signal.aborted) return made.dispose();
				made.setDark(this.#isDark());
				made.setTurning(this.getAttribute("autorotate"));
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

	/** The plant as it is now, once it has grown. */
	async #whole(): Promise<Shown> {
		this.#flush();
		if (this.#due) this.grow();
		await this.#growing;
		if (!this.#shown) throw new Error("No plant has grown yet.");
		return this.#shown;
	}

	/** The last plant stays. */
	#fail(error: unknown): void {
		const message = error instanceof Error ? error.message : String(error);
		this.#message.textContent = message;
		this.#message.hidden = false;
		this.dispatchEvent(new CustomEvent("error", { detail: { message } }));
	}

	/** What a screen reader says of the view. */
	#say(): void {
		const { model, specimen, grown } = this.#shown ?? {};
		const title = model && specimen && (model.presets.named(specimen.preset)?.title ?? model.title);
		const words = model && specimen && grown && `${title}: ${model.words(grown, specimen)}`;
		this.#canvas.setAttribute("aria-label", this.getAttribute("alt") ?? words ?? "A plant, growing");
	}

	#isDark(): boolean {
		const theme = this.getAttribute("theme");
		return theme === "dark" || (theme !== "light" && matchMedia("(prefers-color-scheme: dark)").matches);
	}
}

const namesOf = (changes: readonly MutationRecord[]) => changes.map(({ attributeName }) => attributeName ?? "");
const isSeen = (entries: readonly IntersectionObserverEntry[]) => entries.at(-1)?.isIntersecting ?? false;
