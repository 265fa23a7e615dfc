import { html, nothing } from "lit";
import { classMap } from "lit/directives/class-map.js";
import { DEFAULT_PRESET, presetNamed } from "../../models/bunch/presets/index";
import { withParameters } from "../../specimen/edit";
import { specimenFromPreset } from "../../specimen/from_preset";
import { sameSpecimen } from "../../specimen/same";
import { growsAlike } from "../change";
import { procedureOf } from "../panel_groups";
import { SolidView } from "../solid_view";
import type { Studio } from "../studio";
import type { Failure } from "../types";
import { bunchInWords, stemsInWords } from "../words";
import { type IconName, icon } from "./icons";
import { StudioElement } from "./studio_element";

/** The 3-D view with its tools, its caption, and in its place the words for when there is nothing to see. */
export class Stage extends StudioElement {
	static override properties = { ...StudioElement.properties, trouble: { state: true } };
	/** Why there is no picture: no WebGL 2, or a lost context. */
	declare private trouble: { title: string; text: string } | undefined;

	#solid: SolidView | undefined;
	#started = false;
	/** A phone shows another view in its place: what cannot be seen is not drawn. */
	#visible = true;
	readonly #resized = new ResizeObserver(([{ contentRect }]) => {
		this.#visible = contentRect.width > 0;
		if (!this.#visible) return;
		this.#solid?.view.resize();
		this.requestUpdate();
	});

	protected override draw(studio: Studio): unknown {
		const { failure, growing, grown, ui } = studio.state;
		const surface = classMap({ "stage-surface": true, handles: ui.octahedron, thinning: ui.thinning && !ui.stems });
		return html`<canvas
				class=${surface} tabindex="0" role="img" aria-label=${described(studio)} aria-describedby="stage-keys" @keydown=${this.#press}
			></canvas>
			<p class="unseen" id="stage-keys">${KEYS}</p>
			${grown ? caption(studio) : nothing}
			${this.trouble && !failure ? message(this.trouble.title, [this.trouble.text]) : nothing}
			${failure ? message(failure.title, failure.details, remedies(studio, failure)) : nothing}
			${this.#solid && !this.trouble ? this.#tools(studio) : nothing}
			${growing ? progress(studio) : nothing}`;
	}

	protected override updated(): void {
		if (!this.#started) void this.#start();
		if (this.#visible) this.#solid?.update(this.studio.state);
	}

	async #start(): Promise<void> {
		this.#started = true;
		const canvas = this.querySelector("canvas") as HTMLCanvasElement;
		try {
			this.#solid = await SolidView.create(canvas, this.studio, {
				lost: () => {
					this.trouble = {
						title: "The picture was lost",
						text: "The graphics card dropped it; it comes back by itself in a moment.",
					};
				},
				restored: () => {
					this.trouble = undefined;
				},
			});
			this.studio.picture = () => (this.#solid as SolidView).picture();
			this.#resized.observe(this);
		} catch (error) {
			const text = error instanceof Error ? error.message : String(error);
			this.trouble = {
				title: "No 3-D view here",
				text: `${text} The profile views, the sliders and the downloads work all the same.`,
			};
		}
		this.studio.setUi({});
	}

	#tools(studio: Studio): unknown {
		const { stems, octahedron, thinning } = studio.state.ui;
		const natural = procedureOf(studio.state.specimen) === "natural";
		const tool = (name: IconName, label: string, click: () => void, pressed?: boolean) =>
			html`<button
				class="button icon" type="button" aria-label=${label} title=${label} aria-pressed=${pressed ?? nothing} @click=${click}
			>${icon(name)}</button>`;
		return html`<div class="stage-tools" role="group" aria-label="3-D view">
			${tool("frame", "Reset view", () => this.#solid?.view.resetView())}
			${tool("stems", "Show stems only", () => studio.setUi({ stems: !stems }), stems)}
			${tool("octahedron", "Octahedron", () => studio.setUi({ octahedron: !octahedron }), octahedron)}
			${natural ? tool("thin", "Thin", () => studio.setUi({ thinning: !thinning }), thinning) : nothing}
		</div>`;
	}

	#press(event: KeyboardEvent): void {
		if (event.ctrlKey || event.metaKey || event.altKey) return;
		if (this.#solid?.press(event)) event.preventDefault();
	}
}

/** What the keys do while the picture has the focus, for those who do not see the help. */
const KEYS = "Arrow keys orbit, with Shift they move; plus and minus go nearer and further, 0 resets the view.";

/** What the picture shows, in words. */
function described(studio: Studio): string {
	const { failure, grown, grownFrom } = studio.state;
	if (grown && grownFrom) return `Grape bunch: ${bunchInWords(grown, grownFrom)}`;
	return failure ? "No bunch has grown" : "Grape bunch, growing";
}

/** As under an engraving: what it is called, and what grew. */
function caption(studio: Studio): unknown {
	const { grown, grownFrom } = studio.state;
	if (!grown || !grownFrom) return nothing;
	const title = presetNamed(grownFrom.preset)?.title;
	// Another seed or another age is no other shape.
	const { seed, parameters } = studio.preset;
	const alike = withParameters({ ...grownFrom, seed }, { age: parameters.age });
	const altered = !growsAlike(alike, studio.preset);
	return html`<div class="caption">
		<h2>${title}${altered ? ", altered" : nothing}</h2>
		<p>${studio.state.ui.stems ? stemsInWords(grown) : bunchInWords(grown, grownFrom)}</p>
	</div>`;
}

function message(title: string, details: readonly string[], actions: unknown = nothing): unknown {
	return html`<div class="stage-message" role="alert">
		<h2>${title}</h2>
		${details.map((line) => html`<p>${line}</p>`)}
		${actions}
	</div>`;
}

/** The ways to a bunch from where there is none. */
function remedies(studio: Studio, failure: Failure): unknown {
	const button = (words: string, click: () => void) =>
		html`<button class="button" type="button" @click=${click}>${words}</button>`;
	return failure.remedies.map((remedy) => {
		if (remedy === "again") return button("Try again", () => studio.growAgain());
		const { specimen } = studio.state;
		if (specimen.grammar !== undefined) return button("Use the built-in grammar", () => studio.drop("grammar"));
		if (sameSpecimen(specimen, specimenFromPreset(DEFAULT_PRESET))) return nothing;
		return button("Open the default bunch", () => studio.choosePreset(DEFAULT_PRESET));
	});
}

function progress(studio: Studio): unknown {
	return html`<div class="growing" role="status">
		<span>Growing</span><progress aria-label="Growing"></progress>
		<button class="button quiet" type="button" @click=${() => studio.cancel()}>Cancel</button>
	</div>`;
}

customElements.define("panicle-stage", Stage);
