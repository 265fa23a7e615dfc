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
import { text } from "./messages.generated";
import { spoken } from "./spoken";
import { namesWithRoom } from "./stage_names";
import { handBack, handOver, isForField, readTyped, typedName } from "./typed";

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
	/** Name of the stage at the last update. */
	#stage: string | undefined;
	/** Observes the names of the stages: their sizes depend on the window and on the reader's fonts. */
	readonly #resized = new ResizeObserver(() => this.#hideNames());

	/** Returns the values whose change redraws the bar: the age, playing, or whether there is a plant. */
	protected override shows(context: EditorContext): readonly unknown[] {
		return [this.age, context.toolState(this.play), context.state.grown !== undefined];
	}

	/** Renders the play button, the slider of the age with the names of the stages, and a text field for the age. */
	protected override draw(context: EditorContext): unknown {
		const { life, age } = this;
		const { min, max, step, unit } = this.#entry;
		const words = spoken(unit);
		const stage = stageOf(life, age);
		const { playing } = context.toolState(this.play);
		const toggle = text(playing ? "pause" : "play");
		return html`<div class=${life.steps ? "life-bar watched" : "life-bar"} @keydown=${this.#shortcut}>
			<div class="transport">
				<button
					class="button icon play" type="button" aria-label=${toggle} aria-keyshortcuts="K"
					title=${text("play_key", { action: playing ? toggle : life.play })} @click=${this.#toggle}
				>${icon(playing ? "pause" : "play")}${life.steps ? html`<span class="word">${toggle}</span>` : nothing}</button>
				${life.steps ? this.#pace() : nothing}
			</div>
			<div class="life">
				<input
					type="range" min=${min} max=${max} step=${step} .value=${live(String(age))}
					aria-label=${life.label} aria-valuetext=${text("stage_and_age", { stage: stage.name, age: `${age} ${words}`.trim() })} aria-describedby=${this.idOf("help")}
					@input=${this.#slide} @change=${this.#held.slid} @dblclick=${this.#reset}
					@keydown=${this.#keyDown} @keyup=${this.#held.up} @blur=${this.#held.up}
				>
				<div class="stages" role="group" aria-label=${text("stages")}>${life.stages.map(
					({ at, name, icon: drawn }) => html`<button
						class="stage-name" type="button" tabindex="-1" aria-current=${name === stage.name} .style=${`--at: ${(at - min) / (max - min)}`}
						@click=${() => this.#setAge(at)}
					>${drawn ? icon(drawn) : nothing}${name}</button>`,
				)}</div>
				${life.stages[0].icon && stage !== life.stages[0] ? html`<span class="stage-first">${icon(life.stages[0].icon)}</span>` : nothing}
				<p class="stage-now" aria-hidden="true">${stage.name}</p>
			</div>
			<input
				class="typed" type="text" inputmode="decimal" autocomplete="off" tabindex="-1" .value=${String(age)}
				aria-label=${typedName(life.label, unit)}
				@change=${this.#type} @keydown=${this.#fieldKey} @focus=${(event: FocusEvent) => (event.target as HTMLInputElement).select()}
			><span class="unit" aria-hidden="true">${unit}</span>
			<span class="unseen" id=${this.idOf("help")}>${text("life_help", { help: life.help, least: String(min), most: `${max} ${words}`.trim() })}</span>
		</div>`;
	}

	/** Draws the buttons for single steps and the playing speed. */
	#pace() {
		const { speed = 1 } = this.context.toolState(this.play);
		return html`<button
				class="button icon" type="button" aria-label=${text("step")} title=${text("step_title")} ?disabled=${!this.context.state.grown} @click=${this.#step}
			>${icon("step")}</button>
			<select aria-label=${text("speed")} title=${text("speed")} @change=${this.#setSpeed}>${SPEEDS.map(
				(each) => html`<option value=${each} ?selected=${each === speed}>${each} ×</option>`,
			)}</select>`;
	}

	/** Updates the slider's filled part and, at another stage, the names that are hidden. */
	protected override updated(): void {
		const { min, max } = this.#entry;
		const done = (this.age - min) / (max - min);
		this.querySelector<HTMLElement>(".life")?.style.setProperty("--share", String(done));
		const { name } = stageOf(this.life, this.age);
		if (name === this.#stage) return;
		if (this.#stage === undefined) this.#observeNames();
		this.#stage = name;
		this.#hideNames();
	}

	/** Ends observing the names. */
	override disconnectedCallback(): void {
		super.disconnectedCallback();
		this.#resized.disconnect();
		this.#stage = undefined;
	}

	/** Observes the sizes of the stages' names, which decide what overlaps. */
	#observeNames(): void {
		for (const each of this.querySelectorAll(".stages, .stage-name")) this.#resized.observe(each);
	}

	/** Hides the names of stages that would overlap others. */
	#hideNames(): void {
		const names = [...this.querySelectorAll<HTMLElement>(".stage-name")];
		const ranges = names.map((name) => {
			const { left, right } = name.getBoundingClientRect();
			return { start: left, end: right };
		});
		const shown = namesWithRoom(
			ranges,
			names.findIndex((name) => name.getAttribute("aria-current") === "true"),
		);
		for (const [index, name] of names.entries()) name.classList.toggle("no-room", !shown[index]);
	}

	/** The document's value of the life's parameter. */
	get age(): number {
		return this.context.state.specimen.parameters[this.life.parameter];
	}

	/** The table's entry of the life's parameter. */
	get #entry(): NumberEntry {
		return this.context.state.model.table.entry(this.life.parameter) as NumberEntry;
	}

	/** Sets the age as a finished change. */
	#setAge(age: number): void {
		this.context.set({ parameters: { [this.life.parameter]: age } });
	}

	/** Sets the age as part of a drag or a run of key presses. */
	#edit(age: number): void {
		this.context.edit({ parameters: { [this.life.parameter]: age }, run: this.#held.run });
	}

	/** Starts or stops playing. */
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
		this.#setAge(nextStep(this.life, this.age, steps));
	}

	/** Sets the speed of playing to the one that the user has chosen. */
	#setSpeed(event: Event): void {
		const speed = Number((event.target as HTMLSelectElement).value);
		this.context.setToolState(this.play, { ...this.context.toolState(this.play), speed });
	}

	/** Sets the age while the slider is dragged. */
	#slide(event: Event): void {
		this.#edit(Number((event.target as HTMLInputElement).value));
	}

	/**
	 * Handles a key on the slider: Delete resets the age, numerals go to the text field, Shift with arrows takes coarse
	 * steps, Page Up and Page Down go to the next or the previous stage.
	 */
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

	/** Handles Enter and Escape in the text field. */
	#fieldKey(event: KeyboardEvent): void {
		handBack(event, this.age, this.querySelector("input[type=range]"));
	}

	/** Handles a key on a button: the space bar presses it. */
	#shortcut(event: KeyboardEvent): void {
		if (event.key !== " " || (event.target as HTMLInputElement).type !== "range") return;
		event.preventDefault();
		this.#toggle();
	}

	/** Restores the preset's age. */
	#reset(): void {
		this.#setAge(this.context.preset.parameters[this.life.parameter]);
	}

	/** Sets the typed age, within the limits; notifies if it was out of range or no number. */
	#type(event: Event): void {
		const field = event.target as HTMLInputElement;
		const typed = readTyped(field.value);
		if (Number.isFinite(typed)) this.#setAge(nearestWithin(this.#entry, typed));
		const { age, life } = this;
		const { min, max, unit } = this.#entry;
		const { label } = life;
		if (!Number.isFinite(typed)) {
			this.context.notify(text("not_a_number", { value: field.value.trim().slice(0, 20) }), [
				text("value_kept", { label, value: `${age} ${unit}`.trim() }),
			]);
		} else if (age !== typed) {
			this.context.notify(text("out_of_range", { label, least: String(min), most: `${max} ${unit}`.trim() }), [
				text("value_changed", { typed: String(typed), used: String(age) }),
			]);
		}
		field.value = String(age);
	}
}

customElements.define("panicle-life", LifeBar);
