import { html, nothing } from "lit";
import { ControlElement } from "../../../ui/control_element";
import { text } from "../messages.generated";
import type { View } from "../profile/handles";
import type { BunchContext } from "../ui/context";
import { changePhoto, photo, removePhoto } from "../ui/photo";

const VIEWS: readonly View[] = ["front", "side"];

/** Controls of a placed photograph: movable or fixed, its view, its opacity, removal. */
export class PhotoControls extends ControlElement<BunchContext> {
	/** Returns the values whose change redraws the controls. */
	protected override shows(context: BunchContext): readonly unknown[] {
		return [context.toolState(photo)];
	}

	/** Renders the controls of a placed photo: whether it can be moved, its view and its opacity. */
	protected override draw(context: BunchContext): unknown {
		const placed = context.toolState(photo);
		if (!placed) return nothing;
		const { view, opacity, loose } = placed;
		return html`<button
				class="button" type="button" aria-pressed=${loose} @click=${() => changePhoto(context, { loose: !loose })}
			>${text("photo_move")}</button>
			<button class="button" type="button" @click=${() => removePhoto(context)}>${text("photo_remove")}</button>
			<label>${text("photo_behind")} <select @change=${(event: Event) => changePhoto(context, { view: (event.target as HTMLSelectElement).value as View })}>
				${VIEWS.map((key) => html`<option value=${key} ?selected=${key === view}>${text(key)}</option>`)}
			</select></label>
			<label>${text("photo_opacity")} <input
				type="range" min="0.1" max="1" step="0.05" .value=${String(opacity)}
				@input=${(event: Event) => changePhoto(context, { opacity: Number((event.target as HTMLInputElement).value) })}
			></label>`;
	}
}

customElements.define("panicle-photo-controls", PhotoControls);
