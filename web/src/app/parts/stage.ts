import { html, nothing } from "lit";
import { ORBIT_KEYS } from "../../render/orbit_keys";
import { fromPreset } from "../../specimen/from_preset";
import { sameSpecimen } from "../../specimen/same";
import { icon } from "../../ui/icons";
import { rove, stopAt } from "../../ui/roving";
import { applying } from "../panel_groups";
import { SolidView } from "../solid_view";
import type { Studio } from "../studio";
import { titleOf } from "../title";
import { type Failure, TRY_AGAIN } from "../types";
import { StudioPart } from "./studio_part";

interface Trouble {
	readonly title: string;
	readonly text: string;
	readonly again?: () => void;
}

/** The 3-D view with its tools and its caption, or a message where there is no picture. */
export class StagePart extends StudioPart {
	/** The reason why there is no picture: no WebGL 2, a lost context, or a script that could not be fetched. */
	#trouble: Trouble | undefined;
	#solid: SolidView | undefined;
	#started = false;
	/** Ends the subscription to the state. */
	#leave: (() => void) | undefined;
	/** Whether an update of the view is scheduled. */
	#due = false;
	/** False while a phone shows another view instead: hidden views are not drawn. */
	#visible = true;
	readonly #resized = new ResizeObserver(([{ contentRect }]) => {
		this.#visible = contentRect.width > 0;
		if (!this.#visible) return;
		this.#solid?.resize();
		this.#follow();
	});

	protected override shows({ state }: Studio): readonly unknown[] {
		const { failure, growing, shown, model, modelUi, tools, specimen } = state;
		return [failure, growing, shown, model, modelUi, tools, failure && specimen, ...applying(modelUi?.tools, specimen)];
	}

	protected override draw(studio: Studio): unknown {
		const { failure, growing, shown } = studio.state;
		return html`<canvas
				class="stage-surface" tabindex="0" role="application" aria-roledescription="3-D view" aria-label=${described(studio)} aria-describedby=${this.idOf("keys")}
				@keydown=${this.#press}
			></canvas>
			<p class="unseen" id=${this.idOf("keys")}>${ORBIT_KEYS}</p>
			${shown ? caption(studio) : nothing}
			<div aria-live="polite">${chips(studio)}</div>
			${warnings(studio)}
			${this.#trouble && !failure ? message(this.#trouble.title, [this.#trouble.text], this.#trouble.again ? button("Try again", this.#trouble.again) : nothing) : nothing}
			${failure ? message(failure.title, failure.details, remedies(studio, failure)) : nothing}
			${this.#solid || this.#trouble ? this.#tools(studio, this.#trouble ? undefined : this.#solid) : nothing}
			${growing ? progress(studio) : nothing}`;
	}

	protected override updated(): void {
		const buttons = this.#buttons();
		stopAt(buttons, buttons.find(({ tabIndex }) => tabIndex === 0) ?? buttons[0]);
		if (!this.#started) void this.#start();
	}

	/** Updates the view in a task of its own, so that the browser may draw a frame after the page's other parts are updated. */
	readonly #follow = (): void => {
		if (this.#due) return;
		this.#due = true;
		setTimeout(() => {
			this.#due = false;
			if (this.#visible) this.#solid?.update(this.context.state);
		});
	};

	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#resized.disconnect();
		this.#leave?.();
		this.#solid?.dispose();
		this.#solid = undefined;
		if (this.#started) this.context.showPicture(undefined);
		this.#started = false;
	}

	async #start(): Promise<void> {
		this.#started = true;
		const canvas = this.querySelector("canvas") as HTMLCanvasElement;
		try {
			const solid = await SolidView.create(canvas, this.context, {
				lost: () =>
					this.#setTrouble({
						title: "The picture was lost",
						text: "The graphics card dropped it; it comes back by itself in a moment.",
					}),
				restored: () => this.#setTrouble(undefined),
				motion: () => this.requestUpdate(),
			});
			if (!this.isConnected) {
				solid.dispose();
				return;
			}
			this.#solid = solid;
			this.requestUpdate();
			this.#leave = this.context.subscribe(this.#follow);
			this.#follow();
			this.#resized.observe(this);
			this.context.showPicture((options) => solid.picture(options));
		} catch (error) {
			const none = error instanceof Error && error.name === "NoWebGL2Error";
			const again = () => {
				this.#setTrouble(undefined);
				void this.#start();
			};
			const why = none ? error.message : `Part of the page could not be fetched. ${TRY_AGAIN}`;
			const text = `${why} The flat views, the sliders and the downloads work all the same.`;
			this.#setTrouble({ title: "No 3-D view here", text, ...(none ? {} : { again }) });
		}
	}

	#setTrouble(trouble: Trouble | undefined): void {
		this.#trouble = trouble;
		this.requestUpdate();
	}

	/** The buttons of the 3-D view; without a view, those of tools that do not need it, such as the grammar. */
	#tools(studio: Studio, solid: SolidView | undefined): unknown {
		const { modelUi, specimen, model } = studio.state;
		const button = (drawn: Parameters<typeof icon>[0], label: string, click: () => void, pressed?: boolean) =>
			html`<button
				class="button icon" type="button" aria-label=${label} title=${label} aria-pressed=${pressed ?? nothing} @click=${click}
			>${icon(drawn)}</button>`;
		const tools = applying(modelUi?.tools, specimen).flatMap((tool) =>
			tool.button && (solid || !tool.interaction)
				? button(tool.button.icon, tool.button.label, () => tool.press?.(studio), tool.button.pressed?.(studio))
				: [],
		);
		if (!solid && tools.length === 0) return nothing;
		return html`<div
			class="stage-tools" role="toolbar" aria-orientation="vertical" aria-label=${solid ? "3-D view" : "Tools"}
			@keydown=${(event: KeyboardEvent) => rove(event, this.#buttons())} @focusin=${(event: Event) => stopAt(this.#buttons(), event.target as HTMLElement)}
		>
			${
				solid
					? [
							button("frame", "Reset view", () => solid.reset()),
							model.still === true || !solid.movesByItself
								? nothing
								: button("wind", "Wind", () => this.#blow(solid), solid.wind),
						]
					: nothing
			}
			${tools}
		</div>`;
	}

	#blow(solid: SolidView): void {
		solid.wind = !solid.wind;
		this.requestUpdate();
	}

	#buttons(): HTMLElement[] {
		return [...this.querySelectorAll<HTMLElement>(".stage-tools button")];
	}

	#press(event: KeyboardEvent): void {
		if (this.#solid?.press(event)) event.preventDefault();
	}
}

/** The text alternative of the picture. */
function described({ state: { failure, shown, model } }: Studio): string {
	if (shown) return `${shown.model.title}: ${shown.model.words(shown.grown, shown.from)}`;
	return failure ? `No ${model.noun} has grown` : `${model.title}, growing`;
}

/** The caption: the plant's title and a description. */
function caption(studio: Studio): unknown {
	const { shown, modelUi, grown } = studio.state;
	if (!shown) return nothing;
	const { model, from } = shown;
	const words = grown && modelUi?.caption ? modelUi.caption(grown, studio) : model.words(shown.grown, from);
	return html`<div class="caption">
		<h2>${titleOf(from, model, modelUi && grown ? modelUi.tools : [])}</h2>
		<p>${words}</p>
	</div>`;
}

/** The tools' chips about the selection in the picture; none while there is no picture. */
function chips(studio: Studio): unknown {
	const { modelUi, specimen, failure, shown } = studio.state;
	if (failure || !shown) return nothing;
	return applying(modelUi?.tools, specimen).map(({ chip }) => {
		const drawn = chip?.draw(studio) ?? nothing;
		return drawn === nothing
			? nothing
			: html`<div class="stage-chip" role="group" aria-label=${chip?.title ?? ""}>${drawn}</div>`;
	});
}

/** The warnings about the plant, over the picture. An open pane shows them, too; then only the pane announces them. */
function warnings(studio: Studio): unknown {
	const { modelUi, grown, grownFrom, specimen, failure } = studio.state;
	const lines = grown && grownFrom && !failure ? (modelUi?.warnings?.(grown, grownFrom) ?? []) : [];
	const read = applying(modelUi?.tools, specimen).some(({ pane }) => pane?.open(studio));
	return html`<div class="stage-warnings" role=${read ? nothing : "status"}>${lines.map((line) => html`<p>${line}</p>`)}</div>`;
}

function message(title: string, details: readonly string[], actions: unknown = nothing): unknown {
	return html`<div class="stage-message" role="alert">
		<h2>${title}</h2>
		${details.map((line) => html`<p>${line}</p>`)}
		${actions}
	</div>`;
}

function button(words: string, click: () => void): unknown {
	return html`<button class="button" type="button" @click=${click}>${words}</button>`;
}

/** Buttons that may lead to a plant after a failure. */
function remedies(studio: Studio, failure: Failure): unknown {
	return failure.remedies.map((remedy) => {
		if (remedy === "again") return button("Try again", () => studio.growAgain());
		const { model, specimen, modelUi } = studio.state;
		const own = applying(modelUi?.tools, specimen).flatMap((tool) => tool.remedies ?? []);
		if (own.length > 0) return own.map(({ words, press }) => button(words, () => press(studio)));
		const standard = fromPreset(model);
		if (sameSpecimen(specimen, standard)) return nothing;
		return button(`Open the default ${model.noun}`, () => studio.replace(standard));
	});
}

function progress(studio: Studio): unknown {
	return html`<div class="growing" role="status">
		<span>Growing</span><progress aria-label="Growing"></progress>
		<button class="button quiet" type="button" title="Cancel (Esc)" aria-keyshortcuts="Escape" @click=${() => studio.cancel()}>Cancel</button>
	</div>`;
}

customElements.define("panicle-stage", StagePart);
