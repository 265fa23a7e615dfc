import { html, nothing } from "lit";
import { dropsOf, takeFile } from "../files/drops";
import { text } from "../messages.generated";
import { applying } from "../panel_groups";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";

/** Opens files dropped anywhere on the page; while a file hovers, shows which files can be used. */
export class Drop extends StudioPart {
	#hovering = false;

	/** Returns the values whose change redraws the list of usable files. */
	protected override shows({ state: { modelUi, specimen } }: Studio): readonly unknown[] {
		return this.#hovering ? applying(modelUi?.tools, specimen) : [];
	}

	/** Renders which files can be used, while a file hovers over the page. */
	protected override draw(studio: Studio): unknown {
		if (!this.#hovering) return nothing;
		const lines = [text("open_drop"), ...dropsOf(studio).map(({ description }) => description)];
		return html`<div class="drop">${lines.map((line) => html`<p>${line}</p>`)}</div>`;
	}

	/** Starts to listen for files. */
	override connectedCallback(): void {
		super.connectedCallback();
		window.addEventListener("dragover", this.#over);
		window.addEventListener("dragleave", this.#leave);
		window.addEventListener("drop", this.#drop);
	}

	/** Stops listening. */
	override disconnectedCallback(): void {
		super.disconnectedCallback();
		window.removeEventListener("dragover", this.#over);
		window.removeEventListener("dragleave", this.#leave);
		window.removeEventListener("drop", this.#drop);
	}

	/** Shows or hides the list of usable files. */
	#hover(on: boolean): void {
		this.#hovering = on;
		this.requestUpdate();
	}

	/** Accepts a file that hovers over the page. */
	readonly #over = (event: DragEvent): void => {
		if (!event.dataTransfer?.types.includes("Files")) return;
		// Another part of the page takes the file.
		this.#hover(!event.defaultPrevented);
		event.preventDefault();
	};

	/** Hides the list when the file leaves the page. */
	readonly #leave = (event: DragEvent): void => {
		// Ignore moves between elements of the page.
		if (event.relatedTarget === null) this.#hover(false);
	};

	/** Opens the dropped file. */
	readonly #drop = (event: DragEvent): void => {
		this.#hover(false);
		const file = event.dataTransfer?.files[0];
		// Another part of the page has taken the file.
		if (!file || event.defaultPrevented) return;
		event.preventDefault();
		void takeFile(this.context, file);
	};
}

customElements.define("panicle-drop", Drop);
