/** The button that pauses the wind (WCAG 2.2, success criterion 2.2.2). */
import type { GrownDocument } from "../grown_detail";
import { text } from "../messages.generated";
import type { SpecimenView } from "../specimen_view";
import type { Extra, ExtrasHost } from "./extras";

const STYLE = `
	.pause {
		position: absolute;
		inset: 6px 6px auto auto;
		display: grid;
		place-items: center;
		width: 32px;
		height: 32px;
		padding: 0;
		border: 1px solid color-mix(in srgb, currentcolor 25%, transparent);
		border-radius: 6px;
		background: color-mix(in srgb, var(--panicle-paper) 80%, transparent);
		color: inherit;
		cursor: pointer;
	}
	.pause[hidden] { display: none; }
	.pause:hover { background: var(--panicle-paper); }
	.pause:focus-visible { outline: 2px solid var(--panicle-focus); outline-offset: -2px; }
	.pause svg { width: 18px; height: 18px; fill: currentcolor; }
`;
const PAUSE = "M6 4.500h2.700v11H6zM11.300 4.500H14v11h-2.700z";
const GO_ON = "M6.500 4.200 15 10l-8.500 5.800z";

export class Pause implements Extra {
	readonly #root: ShadowRoot;
	readonly #view: SpecimenView;
	readonly #button = Object.assign(document.createElement("button"), { type: "button", className: "pause" });
	readonly #drawing = document.createElementNS("http://www.w3.org/2000/svg", "path");
	readonly #style = new CSSStyleSheet();
	readonly #ended = new AbortController();
	#sways = false;
	#paused = false;

	/** Adds the button and its style to the element's shadow root. */
	constructor({ root }: Pick<ExtrasHost, "root">, view: SpecimenView) {
		this.#root = root;
		this.#view = view;
		this.#style.replaceSync(STYLE);
		root.adoptedStyleSheets.push(this.#style);
		const svg = document.createElementNS("http://www.w3.org/2000/svg", "svg");
		svg.setAttribute("viewBox", "0 0 20 20");
		svg.setAttribute("aria-hidden", "true");
		svg.append(this.#drawing);
		this.#button.append(svg);
		this.#button.ariaLabel = text("pause_wind");
		this.#button.part.add("pause");
		this.#button.addEventListener("click", () => {
			this.#paused = !this.#paused;
			this.#follow();
		});
		const { signal } = this.#ended;
		matchMedia("(prefers-reduced-motion: reduce)").addEventListener("change", () => this.#follow(), { signal });
		root.append(this.#button);
		this.#follow();
	}

	/** Follows a grown plant: there is a button where wind moves its model. */
	show({ model }: Pick<GrownDocument, "model">): void {
		this.#sways = model.still !== true;
		this.#follow();
	}

	/** Removes the button; the wind goes on. */
	dispose(): void {
		this.#ended.abort();
		this.#view.setPaused(false);
		this.#button.remove();
		this.#root.adoptedStyleSheets = this.#root.adoptedStyleSheets.filter((sheet) => sheet !== this.#style);
	}

	/** Updates the button; hidden where nothing is animated. */
	#follow(): void {
		this.#view.setPaused(this.#paused);
		this.#button.hidden = !this.#sways || !this.#view.turnsByItself;
		this.#button.ariaPressed = `${this.#paused}`;
		this.#button.title = text(this.#paused ? "resume_wind" : "pause_wind");
		this.#drawing.setAttribute("d", this.#paused ? GO_ON : PAUSE);
	}
}
