import { html, nothing } from "lit";
import { dropsOf, takeFile } from "../files/drops";
import { applying } from "../panel_groups";
import type { Studio } from "../studio";
import { StudioPart } from "./studio_part";

/** Opens files dropped anywhere on the page; while a file hovers, shows which files can be used. */
export class Drop extends StudioPart {
	#hovering = false;

	protected override shows({ state: { modelUi, specimen } }: Studio): readonly unknown[] {
		return this.#hovering ? applying(modelUi?.tools, specimen) : [];
	}

	protected override draw(studio: Studio): unknown {
		if (!this.#hovering) return nothing;
		const words = [
			"Drop a GLB, JSON or PNG and its plant comes back, a grammar (.lsys) and it grows",
			...dropsOf(studio).map(({ words }) => words),
		];
		return html`<div class="drop">${words.join("; ")}</div>`;
	}

	override connectedCallback(): void {
		super.connectedCallback();
		window.addEventListener("dragover", this.#over);
		window.addEventListener("dragleave", this.#leave);
		window.addEventListener("drop", this.#drop);
	}

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		window.removeEventListener("dragover", this.#over);
		window.removeEventListener("dragleave", this.#leave);
		window.removeEventListener("drop", this.#drop);
	}

	#hover(on: boolean): void {
		this.#hovering = on;
		this.requestUpdate();
	}

	readonly #over = (event: DragEvent): void => {
		if (!event.dataTransfer?.types.includes("Files")) return;
		// Another part of the page takes the file.
		this.#hover(!event.defaultPrevented);
		event.preventDefault();
	};

	readonly #leave = (event: DragEvent): void => {
		// Ignore moves between elements of the page.
		if (event.relatedTarget === null) this.#hover(false);
	};

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
