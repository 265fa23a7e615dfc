/** The plant in the user's room: a session of augmented reality in the page (WebXR). */
import { html, render } from "lit";
import type { SolidView } from "../solid_view";
import type { Studio } from "../studio";
import { text } from "./messages.generated";

export class Room {
	readonly #view: SolidView;
	readonly #studio: Studio;
	/** Words and a button over the camera's picture, where the browser can show them. */
	readonly #overlay = document.createElement("div");
	/** The element that had the focus before. */
	readonly #opener = document.activeElement;
	#session: XRSession | undefined;
	#isDisposed = false;

	constructor(view: SolidView, studio: Studio) {
		this.#view = view;
		this.#studio = studio;
		this.#overlay.className = "room-overlay";
		this.#overlay.hidden = true;
		document.body.append(this.#overlay);
		void this.#run();
	}

	/** Ends the session. */
	dispose(): void {
		this.#isDisposed = true;
		this.#session?.end().catch(() => {}); // It may have ended already.
		this.#overlay.remove();
		if (this.#opener instanceof HTMLElement && this.#opener.isConnected) this.#opener.focus({ preventScroll: true });
	}

	/** Starts the session and follows it to its end; errors are shown as a notice. */
	async #run(): Promise<void> {
		this.#studio.retract("room");
		try {
			this.#session = await requestSession(this.#overlay);
			if (this.#isDisposed) return void this.#session.end().catch(() => {});
			this.#overlay.hidden = false;
			this.#draw(text("room_place"));
			await this.#view.showInRoom(this.#session, () => this.#draw(text("room_move")));
		} catch (error) {
			void this.#session?.end().catch(() => {}); // It may have ended already.
			if (!this.#isDisposed) this.#report(error);
		}
		if (!this.#isDisposed) this.#studio.setAid(undefined);
	}

	/** Draws the overlay. A press of its button places no plant. */
	#draw(words: string): void {
		const keep = (event: Event) => event.preventDefault();
		render(
			html`<p role="status">${words}</p>
				<button class="button" type="button" @beforexrselect=${keep} @click=${() => this.#studio.setAid(undefined)}>${text("room_close")}</button>`,
			this.#overlay,
		);
	}

	#report(error: unknown): void {
		const isRefused = error instanceof DOMException && ["NotAllowedError", "SecurityError"].includes(error.name);
		const details = [text(isRefused ? "room_refused_details" : "room_failed_details")];
		this.#studio.notify(text(isRefused ? "room_refused" : "room_failed"), details, { topic: "room" });
	}
}

/** Requests a session that finds surfaces; call it during a press. @throws DOMException if the browser refuses */
async function requestSession(root: Element): Promise<XRSession> {
	if (!navigator.xr) throw new Error("The browser has no WebXR.");
	return navigator.xr.requestSession("immersive-ar", {
		requiredFeatures: ["hit-test"],
		optionalFeatures: ["dom-overlay"],
		domOverlay: { root },
	});
}
