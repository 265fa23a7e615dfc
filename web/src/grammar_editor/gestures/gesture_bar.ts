import { html, nothing } from "lit";
import { EditorElement } from "../../ui/editor_element";
import type { DrivenBy, GestureState, Gestures } from "../gesture_tool";
import type { GrammarContext } from "../source";
import { Axes, type Axis } from "./axis";
import { nextPair, pairOf } from "./pair";

const DRIVERS: readonly (readonly [by: DrivenBy, words: string])[] = [
	["pointer", "Pointer"],
	["gamepad", "Gamepad"],
	["camera", "Hand before the camera"],
];

/** Controls of the gesture tool: the two numbers, and the device that controls them. */
class GestureBar extends EditorElement<GrammarContext> {
	static override properties = { ...EditorElement.properties, gestures: { attribute: false } };
	declare gestures: Gestures;

	#axes: Axes | undefined;

	protected override shows(context: GrammarContext): readonly unknown[] {
		const { specimen } = context.state;
		return [context.toolState(this.gestures.tool), specimen.preset, specimen.grammar, specimen.parameters];
	}

	protected override draw(context: GrammarContext): unknown {
		this.#axes ??= new Axes(context, this.gestures.source, () => this.requestUpdate());
		const state = context.toolState(this.gestures.tool);
		if (!state.open) return nothing;
		const all = this.#axes.all;
		const pair = pairOf(all, state);
		return html`<div class="gesture-bar">
			${this.#choice("Across", all, pair.across, (across) => this.#set({ across }))}
			${this.#choice("Up", all, pair.up, (up) => this.#set({ up }))}
			<button class="button" type="button" title="The next two numbers" @click=${() => this.#set(nextPair(all, { across: pair.across?.id, up: pair.up?.id }))}>Next two</button>
			<label>By <select @change=${(event: Event) => this.#set({ by: (event.target as HTMLSelectElement).value as DrivenBy, words: "" })}>
				${DRIVERS.map(([by, words]) => html`<option value=${by} ?selected=${by === state.by}>${words}</option>`)}
			</select></label>
			<p role="status">${state.words || (state.by === "pointer" ? "Hold the pointer down on the picture and move it." : nothing)}</p>
			${state.by === "camera" ? html`<p>The camera’s picture stays in this page: it is looked at here, and neither sent nor kept.</p>` : nothing}
		</div>`;
	}

	#choice(label: string, all: readonly Axis[], chosen: Axis | undefined, choose: (id: string) => void): unknown {
		return html`<label>${label} <select @change=${(event: Event) => choose((event.target as HTMLSelectElement).value)}>
			${all.map(({ id, label: words }) => html`<option value=${id} ?selected=${id === chosen?.id}>${words}</option>`)}
		</select></label>`;
	}

	#set(change: Partial<GestureState>): void {
		const { tool } = this.gestures;
		this.context.setToolState(tool, { ...this.context.toolState(tool), ...change });
	}
}

customElements.define("panicle-gestures", GestureBar);
