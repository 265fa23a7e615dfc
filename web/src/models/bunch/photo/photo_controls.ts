import { html, nothing } from "lit";
import { ControlElement } from "../../../ui/control_element";
import type { View } from "../profile/handles";
import type { BunchContext } from "../ui/context";
import { changePhoto, photo, removePhoto } from "../ui/photo";

const VIEWS: readonly (readonly [View, string])[] = [
	["front", "Front"],
	["side", "Side"],
];

/** Controls of a placed photograph: movable or fixed, its view, its opacity, removal. */
export class PhotoControls extends ControlElement<BunchContext> {
	protected override shows(context: BunchContext): readonly unknown[] {
		return [context.toolState(photo)];
	}

	protected override draw(context: BunchContext): unknown {
		const placed = context.toolState(photo);
		if (!placed) return nothing;
		const { view, opacity, loose } = placed;
		return html`<button
				class="button" type="button" aria-pressed=${loose} @click=${() => changePhoto(context, { loose: !loose })}
			>Shift photograph</button>
			<button class="button" type="button" @click=${() => removePhoto(context)}>Remove photograph</button>
			<label>Behind <select @change=${(event: Event) => changePhoto(context, { view: (event.target as HTMLSelectElement).value as View })}>
				${VIEWS.map(([key, words]) => html`<option value=${key} ?selected=${key === view}>${words}</option>`)}
			</select></label>
			<label>Opacity <input
				type="range" min="0.1" max="1" step="0.05" .value=${String(opacity)}
				@input=${(event: Event) => changePhoto(context, { opacity: Number((event.target as HTMLInputElement).value) })}
			></label>`;
	}
}

customElements.define("panicle-photo-controls", PhotoControls);
