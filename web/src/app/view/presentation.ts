/** The presentation: the plant alone in the whole window, turning slowly. */
import { html, nothing, render } from "lit";
import type { SolidView } from "../solid_view";
import type { Studio } from "../studio";
import { text } from "./messages.generated";

/** Time of one turn of the plant, milliseconds. */
const TURN = 45_000;
/** Longest step of the turn, milliseconds: after a pause the plant does not jump. */
const LONGEST_STEP = 100;
/** Time that the buttons stay after the pointer has moved, milliseconds. */
const BUTTONS_STAY = 3000;

export class Presentation {
	readonly #place: HTMLElement;
	readonly #view: SolidView;
	readonly #studio: Studio;
	readonly #page: HTMLElement;
	/** The element that had the focus before. */
	readonly #opener: Element | null;
	readonly #lifetime = new AbortController();
	#frame = 0;
	#last = 0;
	/** Whether a pointer turns the plant. */
	#pressed = false;
	#buttonsShown = false;
	#hiding: ReturnType<typeof setTimeout> | undefined;

	/** @param place empty live region over the canvas */
	constructor(place: HTMLElement, view: SolidView, studio: Studio) {
		this.#place = place;
		this.#view = view;
		this.#studio = studio;
		this.#page = view.canvas.closest<HTMLElement>(".studio") ?? document.body;
		this.#opener = document.activeElement;
		this.#page.toggleAttribute("data-presenting", true);
		view.showsAids = false;
		view.canvas.focus({ preventScroll: true });
		this.draw();
		this.#listen();
		this.#fillScreen();
		this.#frame = requestAnimationFrame(this.#turn);
	}

	/** Draws the buttons; call it after changes of the state. */
	draw(): void {
		const on = this.#studio.state.ui.scaleBar === true;
		render(
			html`<p class="unseen">${text("presentation_help")}</p>
				<div class="presentation-buttons" ?data-shown=${this.#buttonsShown}>
					<button class="button" type="button" aria-pressed=${on} @click=${() => this.#studio.setUi({ scaleBar: on ? undefined : true })}>${text("presentation_scale")}</button>
					<button class="button" type="button" @click=${() => this.#studio.setAid(undefined)}>${text("presentation_leave")}</button>
				</div>`,
			this.#place,
		);
	}

	dispose(): void {
		cancelAnimationFrame(this.#frame);
		clearTimeout(this.#hiding);
		this.#lifetime.abort();
		this.#page.removeAttribute("data-presenting");
		this.#view.showsAids = true;
		if (document.fullscreenElement) document.exitFullscreen().catch(() => {});
		const back = this.#opener?.isConnected && this.#opener !== document.body ? this.#opener : this.#view.canvas;
		if (back instanceof HTMLElement) back.focus({ preventScroll: true });
		render(nothing, this.#place);
	}

	#listen(): void {
		const { signal } = this.#lifetime;
		const leave = () => this.#studio.setAid(undefined);
		const press = (event: KeyboardEvent) => {
			if (event.key !== "Escape" || event.defaultPrevented || document.querySelector("dialog[open]")) return;
			event.preventDefault();
			leave();
		};
		window.addEventListener("keydown", press, { signal });
		// The browser's own way out of the full screen leaves the presentation, too.
		const change = () => {
			if (!document.fullscreenElement) leave();
		};
		document.addEventListener("fullscreenchange", change, { signal });
		window.addEventListener("pointermove", () => this.#showButtons(), { signal });
		const hold = ({ type, target }: Event) => {
			this.#pressed = type === "pointerdown" && target === this.#view.canvas;
			this.#showButtons();
		};
		for (const type of ["pointerdown", "pointerup", "pointercancel"]) window.addEventListener(type, hold, { signal });
	}

	/** Fills the screen where the browser allows it; elsewhere, the plant fills the page's window. */
	#fillScreen(): void {
		document.documentElement.requestFullscreen?.({ navigationUI: "hide" }).catch(() => {});
	}

	/** Shows the buttons for a while. */
	#showButtons(): void {
		clearTimeout(this.#hiding);
		this.#hiding = setTimeout(() => {
			this.#buttonsShown = false;
			this.draw();
		}, BUTTONS_STAY);
		if (this.#buttonsShown) return;
		this.#buttonsShown = true;
		this.draw();
	}

	/** Turns the plant by the time since the last frame, unless motion is unwanted or a pointer turns it. */
	readonly #turn = (now: number): void => {
		if (!this.#view.movesByItself) return;
		const step = Math.min(now - (this.#last || now), LONGEST_STEP);
		this.#last = now;
		if (!this.#pressed) this.#view.turn((2 * Math.PI * step) / TURN);
		this.#frame = requestAnimationFrame(this.#turn);
	};
}
