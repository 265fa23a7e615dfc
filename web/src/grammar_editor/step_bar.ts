import { html, LitElement, svg } from "lit";
import { live } from "lit/directives/live.js";
import { icon } from "../ui/icons";
import { text } from "./messages.generated";
import { CHART_HEIGHT, stepChart } from "./step_chart";
import { countInWords, stepInWords } from "./trace_words";

const ICONS = {
	first: svg`<path d="M15 4.8v10.4L8 10z" fill="currentcolor"/><path d="M5 4.8v10.4" stroke-width="2"/>`,
	back: svg`<path d="M13.5 4.8v10.4L6.5 10z" fill="currentcolor"/>`,
	forward: svg`<path d="M6.5 4.8v10.4l7-5.2z" fill="currentcolor"/>`,
	plant: svg`<path d="M10 17.5V9M10 12.5c0-3.5 2-5.5 6-5.5 0 3.5-2 5.5-6 5.5zM10 9.5C10 6.2 8 4 4.5 4c0 3.5 2 5.5 5.5 5.5z"/>`,
	last: svg`<path d="M5 4.8v10.4L12 10z" fill="currentcolor"/><path d="M15 4.8v10.4" stroke-width="2"/>`,
};

/** Controls of the derivation's steps: a slider over a chart of the strings' lengths, and buttons. */
export class StepBar extends LitElement {
	static override properties = {
		counts: { attribute: false },
		step: { attribute: false },
		playing: { attribute: false },
		go: { attribute: false },
		by: { attribute: false },
		play: { attribute: false },
		follows: { attribute: false },
		follow: { attribute: false },
	};
	/** Modules of each step's string. */
	declare counts: Uint32Array;
	declare step: number;
	declare playing: boolean;
	/** Goes to a step. */
	declare go: (step: number) => void;
	/** Moves one step forward or back, together with the chosen module. */
	declare by: (by: 1 | -1) => void;
	declare play: () => void;
	/** Whether the view shows the plant of the step, and the function that toggles this. */
	declare follows: boolean;
	declare follow: () => void;

	/** Renders into the element itself, so that the page's style applies. */
	protected override createRenderRoot(): this {
		return this;
	}

	/**
	 * Renders the buttons, the step's size in words, and the slider above a chart of the string's length at each step.
	 */
	protected override render(): unknown {
		const { counts, step } = this;
		const last = counts.length - 1;
		const words = text("step_and_count", { step: stepInWords(step, last), count: countInWords(counts[step]) });
		const button = (label: string, drawn: unknown, click: () => void, off: boolean) =>
			html`<button class="button icon quiet" type="button" aria-label=${label} title=${label} aria-disabled=${off} @click=${() => off || click()}>${drawn}</button>`;
		return html`<div class="step-bar">
			<div class="step-buttons" role="group" aria-label=${text("steps")}>
				${button(text("first_step"), icon(ICONS.first), () => this.go(0), step === 0)}
				${button(text("step_back"), icon(ICONS.back), () => this.by(-1), step === 0)}
				${button(text(this.playing ? "pause_steps" : "play_steps"), icon(this.playing ? "pause" : "play"), () => this.play(), last === 0)}
				${button(text("step_forward"), icon(ICONS.forward), () => this.by(1), step === last)}
				${button(text("last_step"), icon(ICONS.last), () => this.go(last), step === last)}
				<button
					class="button icon quiet" type="button" aria-label=${text("follow_step")} title=${text("follow_step")}
					aria-pressed=${this.follows} @click=${() => this.follow()}
				>${icon(ICONS.plant)}</button>
			</div>
			<p class="step-now"><b>${stepInWords(step, last)}</b> ${countInWords(counts[step])}</p>
			<div class="step-slide">
				<svg viewBox="0 0 100 ${CHART_HEIGHT}" preserveAspectRatio="none" aria-hidden="true">
					<path class="ahead" d=${stepChart(counts)}></path>
					<path class="done" d=${stepChart(counts, step)}></path>
				</svg>
				<input
					type="range" min="0" max=${last} step="1" .value=${live(String(step))} ?disabled=${last === 0}
					aria-label=${text("step")} aria-valuetext=${words} .style=${`--done: ${last > 0 ? (100 * step) / last : 0}%`}
					@input=${(event: Event) => this.go(Number((event.target as HTMLInputElement).value))}
				>
			</div>
		</div>`;
	}
}

customElements.define("panicle-steps", StepBar);
