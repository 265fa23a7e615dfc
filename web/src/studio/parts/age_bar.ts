import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
import { entryOf, type NumberEntry, nearestWithin } from "../../specimen/table";
import { nextStage, STAGES, stageOf } from "../age";
import { procedureOf } from "../panel_groups";
import type { Studio } from "../studio";
import { icon } from "./icons";
import { StudioElement } from "./studio_element";

const AGE = entryOf("age") as NumberEntry;
const STEP = 0.5;
const MOVING_KEYS = /^(Arrow|Page|Home|End)/;

/** The age below the view: a slider over the stages of a bunch's life, a button that lets it run, the number to type. */
export class AgeBar extends StudioElement {
	#keyHeld = false;

	protected override draw(studio: Studio): unknown {
		const { specimen, playing } = studio.state;
		this.hidden = procedureOf(specimen) !== "natural";
		if (this.hidden) return nothing;
		const { age } = specimen.parameters;
		const stage = stageOf(age);
		const words = playing ? "Pause" : "Play";
		return html`<div class="age" @keydown=${this.#shortcut}>
			<button
				class="button icon play" type="button" aria-label=${words} aria-keyshortcuts="K"
				title=${playing ? "Pause (K)" : "Play from flower to ripe bunch (K)"} @click=${() => studio.setPlaying(!playing)}
			>${icon(playing ? "pause" : "play")}</button>
			<div class="life">
				<input
					type="range" id="slide-age" min=${AGE.min} max=${AGE.max} step=${STEP} .value=${live(String(age))}
					aria-label="Age" aria-valuetext="${stage.name}, ${age} percent" aria-describedby="help-age"
					@input=${this.#slide} @change=${this.#slid} @dblclick=${this.#reset}
					@keydown=${this.#keyDown} @keyup=${this.#keyUp} @blur=${this.#keyUp}
				>
				<div class="stages" role="group" aria-label="Stages">${STAGES.map(
					({ at, name }) => html`<button
						class="stage-name" type="button" aria-current=${name === stage.name} .style=${`--at: ${at / AGE.max}`}
						@click=${() => studio.set({ parameters: { age: at } })}
					>${name}</button>`,
				)}</div>
				<p class="stage-now" aria-hidden="true">${stage.name}</p>
			</div>
			<input
				class="typed" type="text" inputmode="decimal" autocomplete="off" .value=${live(String(age))} aria-label="Age in percent"
				@change=${this.#type} @focus=${(event: FocusEvent) => (event.target as HTMLInputElement).select()}
			><span class="unit" aria-hidden="true">%</span>
			<span class="unseen" id="help-age">0 first flowers open, 10 fruit set, 60 colouring begins, 100 ripe, ${AGE.max} shrivelled.
				Page keys go from stage to stage, K plays, Delete brings the preset’s age back. ${AGE.min} … ${AGE.max} percent.</span>
		</div>`;
	}

	protected override updated(): void {
		const { age } = this.studio.state.specimen.parameters;
		this.querySelector<HTMLElement>("#slide-age")?.style.setProperty("--done", `${(age / AGE.max) * 100}%`);
	}

	#slide(event: Event): void {
		this.studio.edit({ parameters: { age: Number((event.target as HTMLInputElement).value) } });
	}

	#slid(): void {
		if (!this.#keyHeld) this.studio.settle();
	}

	#keyDown(event: KeyboardEvent): void {
		const { key } = event;
		if (key === "Delete" || key === "Backspace") this.#reset();
		else if (MOVING_KEYS.test(key)) this.#keyHeld = true;
		if (key !== "PageUp" && key !== "PageDown") return;
		event.preventDefault();
		const { age } = this.studio.state.specimen.parameters;
		this.studio.edit({ parameters: { age: nextStage(age, key === "PageUp" ? 1 : -1).at } });
	}

	#keyUp(): void {
		if (this.#keyHeld) this.studio.settle();
		this.#keyHeld = false;
	}

	/** On a button the space bar is the button's own. */
	#shortcut(event: KeyboardEvent): void {
		if (event.key !== " " || (event.target as Element).id !== "slide-age") return;
		event.preventDefault();
		this.studio.setPlaying(!this.studio.state.playing);
	}

	#reset(): void {
		this.studio.set({ parameters: { age: this.studio.preset.parameters.age } });
	}

	#type(event: Event): void {
		const field = event.target as HTMLInputElement;
		const text = field.value.trim().replace(",", ".");
		const typed = text === "" ? Number.NaN : Number(text);
		if (Number.isFinite(typed)) this.studio.set({ parameters: { age: nearestWithin(AGE, typed) } });
		const { age } = this.studio.state.specimen.parameters;
		if (!Number.isFinite(typed)) this.studio.notify(`“${text.slice(0, 20)}” is not an age`, [`Age ${age} % stays.`]);
		else if (age !== typed) this.studio.notify(`Age takes ${AGE.min} … ${AGE.max} %`, [`${typed} became ${age}.`]);
		field.value = String(age);
	}
}

customElements.define("panicle-age", AgeBar);
