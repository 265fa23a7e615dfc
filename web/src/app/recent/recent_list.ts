/** The list of recent plants as the home page and the studio show it. It needs no model, no core and no 3-D view. */
import { html, nothing, svg, type TemplateResult } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { icon } from "../../ui/icons";
import { drawnJpeg } from "../saved/drawn_jpeg";
import { text } from "./messages.generated";
import type { RecentPlant } from "./recent_plant";
import type { Recents, RemovedRecent } from "./recents";
import { timeInWords } from "./time_in_words";
import "./recent.css";

/** In place of the picture of a plant that was left before it was drawn: a seedling. */
const NO_PICTURE = icon(
	svg`<path d="M10 17V9M10 11C10 8 8 6 4.5 6 4.5 9 6.5 11 10 11zM10 9c0-3 2-5 5.5-5 0 3-2 5-5.5 5z"/>`,
);

/** Shows and changes the list; its owner draws it. */
export class RecentList {
	readonly #recents: Recents;
	/** Draws the list again; may return a promise that resolves when it is drawn. */
	readonly #redraw: () => unknown;
	#plants: readonly RecentPlant[] = [];
	/** Drawn pictures by the plants' ids; undefined where a plant has none. */
	#pictures = new Map<string, HTMLCanvasElement | undefined>();
	#message = "";
	/** Removals that can be undone, the last at the end. */
	#removed: readonly RemovedRecent[] = [];
	#place: HTMLElement | undefined;

	constructor(recents: Recents, redraw: () => unknown) {
		this.#recents = recents;
		this.#redraw = redraw;
	}

	/** Reads the list and its pictures. */
	async read(): Promise<void> {
		this.#plants = await this.#recents.all();
		const pictures = this.#plants.map(async ({ id }) => {
			const { picture } = await this.#recents.content(id);
			return [id, picture && (await drawnJpeg(picture))] as const;
		});
		this.#pictures = new Map(await Promise.all(pictures));
	}

	/** Forgets the message and the removals. */
	reset(): void {
		this.#message = "";
		this.#removed = [];
	}

	/**
	 * Renders the list as a section; nothing if it is empty, and nothing was removed.
	 * @param heading the section's title, as an element
	 * @param open opens a plant on the page; by default plants are links
	 * @param isListed whether a plant is shown
	 */
	draw(
		heading: { readonly title: string; readonly element: TemplateResult },
		open?: (plant: RecentPlant) => void,
		isListed: (plant: RecentPlant) => boolean = () => true,
	): unknown {
		const plants = this.#plants.filter(isListed);
		if (plants.length === 0 && this.#removed.length === 0) return nothing;
		const now = Date.now();
		return html`<section class="recent" aria-label=${heading.title}>
			<div class="recent-head">
				${heading.element}
				<p>${text("where")}</p>
				${plants.length > 0 ? html`<button class="button quiet" type="button" @click=${() => this.#remove(plants)}>${text("clear")}</button>` : nothing}
			</div>
			<div class="recent-message">
				<p role="status">${this.#message}</p>
				${this.#removed.length > 0 ? html`<button class="button" type="button" @click=${this.#undo}>${text("undo")}</button>` : nothing}
			</div>
			<ul class="recent-plants">${repeat(
				plants,
				({ id }) => id,
				(plant) => this.#card(plant, now, open),
			)}</ul>
		</section>`;
	}

	/**
	 * Renders a plant as a card, with a button that removes it.
	 * @param now time of rendering, milliseconds since 1970
	 * @param open opens the plant on the page; absent where the card is a link
	 */
	#card(plant: RecentPlant, now: number, open: ((plant: RecentPlant) => void) | undefined): TemplateResult {
		const { id, title } = plant;
		const content = html`<span class="recent-picture">${this.#pictures.get(id) ?? NO_PICTURE}</span>
			<b title=${title}>${title}</b> <span class="recent-time">${timeInWords(plant, now)}</span>
			${plant.extra === "missing" ? html` <span class="recent-time">${text("incomplete")}</span>` : nothing}`;
		return html`<li>
			${
				open
					? html`<button class="recent-plant" type="button" @click=${() => open(plant)}>${content}</button>`
					: html`<a class="recent-plant" href=${addressOf(plant)}>${content}</a>`
			}
			<button
				class="button quiet icon recent-remove" type="button" aria-label=${text("remove", { title })} title=${text("remove_title")}
				@click=${(event: Event) => this.#remove([plant], event)}
			>${icon("close")}</button>
		</li>`;
	}

	/** Removes plants; the focus moves to the plant after the removed one, or to Undo. */
	async #remove(plants: readonly RecentPlant[], event?: Event): Promise<void> {
		const button = event?.currentTarget as HTMLElement | undefined;
		const card = button?.closest("li");
		const next = (card?.nextElementSibling ?? card?.previousElementSibling)?.querySelector<HTMLElement>(
			".recent-remove",
		);
		this.#place = (card ?? document.activeElement)?.closest<HTMLElement>(".recent") ?? undefined;
		const removed = await this.#recents.remove(plants.map(({ id }) => id));
		if (removed.length > 0) this.#removed = [...this.#removed, removed];
		this.#message = removed.length > 0 ? text("removed", countAndTitle(removed)) : text("not_removed");
		await this.#readAndDraw();
		(next?.isConnected ? next : this.#undoButton())?.focus();
	}

	/** Restores the plants that were removed last, and moves the focus to the next Undo or to a plant. */
	readonly #undo = async (event: Event): Promise<void> => {
		const removed = this.#removed.at(-1);
		if (!removed) return;
		this.#place = (event.currentTarget as HTMLElement).closest<HTMLElement>(".recent") ?? undefined;
		this.#removed = this.#removed.slice(0, -1);
		await this.#recents.restore(removed);
		this.#message = text("restored", countAndTitle(removed));
		await this.#readAndDraw();
		(this.#undoButton() ?? this.#place?.querySelector<HTMLElement>(".recent-plant"))?.focus();
	};

	/** Reads the list and draws it again. */
	async #readAndDraw(): Promise<void> {
		await this.read();
		await this.#redraw();
	}

	/** Returns the button Undo; undefined where there is nothing to undo. */
	#undoButton(): HTMLElement | undefined {
		return this.#place?.querySelector<HTMLElement>(".recent-message .button") ?? undefined;
	}
}

/** Returns the arguments of messages about removed plants: their number and the title of the first. */
const countAndTitle = (removed: RemovedRecent) => ({ count: removed.length, title: removed[0]?.plant.title ?? "" });

/**
 * Returns the address of a plant; of one with stored parts that its link cannot contain, with its id
 * (recent_address.ts).
 */
function addressOf({ id, link, extra }: RecentPlant): string {
	if (extra !== "stored") return link;
	return `${link}${link.includes("#") ? "&" : "#"}recent=${id}`;
}
