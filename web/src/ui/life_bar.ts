import { html, nothing } from "lit";
import { live } from "lit/directives/live.js";
import { type NumberEntry, nearestWithin } from "../specimen/table";
import { coarseStep } from "./coarse_step";
import { ControlElement } from "./control_element";
import type { EditorContext, Stateful } from "./editor_context";
import { HeldKey } from "./held_key";
import { icon } from "./icons";
import { type Life, nextStage, nextStep, SPEEDS, stageOf } from "./life";
import type { PlayState } from "./life_player";
import { spoken } from "./spoken";
import { handBack, handOver, isForField, readTyped } from "./typed";

/** Bar of a life below the view: a slider with its stages, a button that plays, and a field for the number. */
export class LifeBar extends ControlElement {
	static override properties = {
		...ControlElement.properties,
		life: { attribute: false },
		play: { attribute: false },
	};
	declare life: Life;
	/** State that contains whether the life is playing. */
	declare play: Stateful<PlayState>;

	readonly #held = new HeldKey(() => this.context.settle());

	protected override shows(context: EditorContext): readonly unknown[] {
		return [this.age, context.toolState(this.play), context.state.grown !== undefined];
	}

	protected override draw(context: EditorContext): unknown {
		const { life, age } = this;
		const { min, max, step, unit } = this.#entry;
		const words = spoken(unit);
		const stage = stageOf(life, age);
		const { playing } = context.toolState(this.play);
		const name = life.label.toLowerCase();
		return html`<div class=${life.steps ? "life-bar watched" : "life-bar"} @keydown=${this.#shortcut}>
			<div class="transport">
				<button
					class="button icon play" type="button" aria-label=${playing ? "Pause" : "Play"} aria-keyshortcuts="K"
					title="${playing ? "Pause" : life.play} (K)" @click=${this.#toggle}
				>${icon(playing ? "pause" : "play")}${life.steps ? html`<span class="word">${playing ? "Pause" : "Play"}</span>` : nothing}</button>
				${life.steps ? this.#pace() : nothing}
			</div>
			<div class="life">
				<input
					type="range" min=${min} max=${max} step=${step} .value=${live(String(age))}
					aria-label=${life.label} aria-valuetext=${`${stage.name}, ${age} ${words}`.trim()} aria-describedby=${this.idOf("help")}
					@input=${this.#slide} @change=${this.#held.slid} @dblclick=${this.#reset}
					@keydown=${this.#keyDown} @keyup=${this.#held.up} @blur=${this.#held.up}
				>
				<div class="stages" role="group" aria-label="Stages">${life.stages.map(
					({ at, name, icon: drawn }) => html`<button
						class="stage-name" type="button" tabindex="-1" aria-current=${name === stage.name} .style=${`--at: ${(at - min) / (max - min)}`}
						@click=${() => this.#set(at)}
					>${drawn ? icon(drawn) : nothing}${name}</button>`,
				)}</div>
				${life.stages[0].icon && stage !== life.stages[0] ? html`<span class="stage-first">${icon(life.stages[0].icon)}</span>` : nothing}
				<p class="stage-now" aria-hidden="true">${stage.name}</p>
			</div>
			<input
				class="typed" type="text" inputmode="decimal" autocomplete="off" tabindex="-1" .value=${String(age)}
				aria-label=${words ? `${life.label} in ${words}` : `${life.label}, typed`}
				@change=${this.#type} @keydown=${this.#fieldKey} @focus=${(event: FocusEvent) => (event.target as HTMLInputElement).select()}
			><span class="unit" aria-hidden="true">${unit}</span>
			<span class="unseen" id=${this.idOf("help")}>${life.help} Page keys go from stage to stage, K plays, Enter types a number, Delete brings the
				preset’s ${name} back. ${`${min} … ${max} ${words}`.trim()}.</span>
		</div>`;
	}

	/** Draws the buttons for single steps and the playing speed. */
	#pace() {
		const { speed = 1 } = this.context.toolState(this.play);
		return html`<button
				class="button icon" type="button" aria-label="Step" title="One step on" ?disabled=${!this.context.state.grown} @click=${this.#step}
			>${icon("step")}</button>
			<select aria-label="Speed" title="Speed" @change=${this.#hasten}>${SPEEDS.map(
				(each) => html`<option value=${each} ?selected=${each === speed}>${each} ×</option>`,
			)}</select>`;
	}

	protected override updated(): void {
		const { min, max } = this.#entry;
		const done = (this.age - min) / (max - min);
		this.querySelector<HTMLElement>(".life")?.style.setProperty("--share", String(done));
	}

	get age(): number {
		return this.context.state.specimen.parameters[this.life.parameter];
	}

	get #entry(): NumberEntry {
		return this.context.state.model.table.entry(this.life.parameter) as NumberEntry;
	}

	#set(age: number): void {
		this.context.set({ parameters: { [this.life.parameter]: age } });
	}

	#edit(age: number): void {
		this.context.edit({ parameters: { [this.life.parameter]: age }, run: this.#held.run });
	}

	readonly #toggle = (): void => {
		const state = this.context.toolState(this.play);
		this.context.setToolState(this.play, { ...state, playing: !state.playing });
	};

	/** Stops playing and moves one step on. */
	#step(): void {
		const { grown } = this.context.state;
		const steps = grown && this.life.steps?.(grown);
		if (!steps) return;
		this.context.setToolState(this.play, { ...this.context.toolState(this.play), playing: false });
		this.#set(nextStep(this.life, this.age, steps));
	}

	#hasten(event: Event): void {
		const speed = Number((event.target as HTMLSelectElement).value);
		this.context.setToolState(this.play, { ...this.context.toolState(this.play), speed });
	}

	#slide(event: Event): void {
		this.#edit(Number((event.target as HTMLInputElement).value));
	}

	#keyDown(event: KeyboardEvent): void {
		const { key } = event;
		if (key === "Delete" || key === "Backspace") this.#reset();
		else if (isForField(event)) handOver(event, this.querySelector("input.typed"));
		else this.#held.down(event);
		const far = coarseStep(this.#entry.step, event);
		if (far !== undefined) {
			event.preventDefault();
			this.#edit(nearestWithin(this.#entry, this.age + far));
		}
		if (key !== "PageUp" && key !== "PageDown") return;
		event.preventDefault();
		this.#edit(nextStage(this.life, this.age, key === "PageUp" ? 1 : -1).at);
	}

	#fieldKey(event: KeyboardEvent): void {
		handBack(event, this.age, this.querySelector("input[type=range]"));
	}

	/** On a button, the space bar presses the button. */
	#shortcut(event: KeyboardEvent): void {
		if (event.key !== " " || (event.target as HTMLInputElement).type !== "range") return;
		event.preventDefault();
		this.#toggle();
	}

	#reset(): void {
		this.#set(this.context.preset.parameters[this.life.parameter]);
	}

	#type(event: Event): void {
		const field = event.target as HTMLInputElement;
		const typed = readTyped(field.value);
		if (Number.isFinite(typed)) this.#set(nearestWithin(this.#entry, typed));
		const { age, life } = this;
		const { min, max, unit } = this.#entry;
		const name = life.label.toLowerCase();
		if (!Number.isFinite(typed)) {
			this.context.notify(`“${field.value.trim().slice(0, 20)}” is not an ${name}`, [
				`${life.label} ${`${age} ${unit}`.trim()} stays.`,
			]);
		} else if (age !== typed) {
			this.context.notify(`${life.label} takes ${`${min} … ${max} ${unit}`.trim()}`, [`${typed} became ${age}.`]);
		}
		field.value = String(age);
	}
}

customElements.define("panicle-life", LifeBar);
