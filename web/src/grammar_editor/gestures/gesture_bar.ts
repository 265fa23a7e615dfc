import { html, nothing } from "lit";
import { EditorElement } from "../../ui/editor_element";
import type { DrivenBy, GestureState, Gestures } from "../gesture_tool";
import { text } from "../messages.generated";
import type { GrammarContext } from "../source";
import { Axes, type Axis } from "./axis";
import { nextPair, pairOf } from "./pair";

const DRIVERS = ["pointer", "gamepad", "camera"] as const satisfies readonly DrivenBy[];

/** Controls of the gesture tool: the two numbers, and the device that controls them. */
class GestureBar extends EditorElement<GrammarContext> {
	static override properties = { ...EditorElement.properties, gestures: { attribute: false } };
	declare gestures: Gestures;

	#axes: Axes | undefined;

	/** Returns the values whose change redraws the bar: the tool's state or the document's numbers. */
	protected override shows(context: GrammarContext): readonly unknown[] {
		const { specimen } = context.state;
		return [context.toolState(this.gestures.tool), specimen.preset, specimen.grammar, specimen.parameters];
	}

	/** Renders the choice of the two axes and of the device that drives them. */
	protected override draw(context: GrammarContext): unknown {
		this.#axes ??= new Axes(context, this.gestures.source, () => this.requestUpdate());
		const state = context.toolState(this.gestures.tool);
		if (!state.open) return nothing;
		const all = this.#axes.all;
		const pair = pairOf(all, state);
		return html`<div class="gesture-bar">
			${this.#choice(text("across"), all, pair.across, (across) => this.#setState({ across }))}
			${this.#choice(text("up"), all, pair.up, (up) => this.#setState({ up }))}
			<button class="button" type="button" @click=${() => this.#setState(nextPair(all, { across: pair.across?.id, up: pair.up?.id }))}>${text("next_pair")}</button>
			<label>${text("by")} <select @change=${(event: Event) => this.#setState({ by: (event.target as HTMLSelectElement).value as DrivenBy, message: "" })}>
				${DRIVERS.map((by) => html`<option value=${by} ?selected=${by === state.by}>${text(`by_${by}`)}</option>`)}
			</select></label>
			<p role="status">${state.message || (state.by === "pointer" ? text("pointer_hint") : nothing)}</p>
			${state.by === "camera" ? html`<p>${text("camera_private")}</p>` : nothing}
		</div>`;
	}

	/**
	 * Draws the choice of an axis.
	 * @param choose called with the id of the chosen axis
	 */
	#choice(label: string, all: readonly Axis[], chosen: Axis | undefined, choose: (id: string) => void): unknown {
		return html`<label>${label} <select @change=${(event: Event) => choose((event.target as HTMLSelectElement).value)}>
			${all.map(({ id, label }) => html`<option value=${id} ?selected=${id === chosen?.id}>${label}</option>`)}
		</select></label>`;
	}

	/** Changes the tool's state. */
	#setState(change: Partial<GestureState>): void {
		const { tool } = this.gestures;
		this.context.setToolState(tool, { ...this.context.toolState(tool), ...change });
	}
}

customElements.define("panicle-gestures", GestureBar);
