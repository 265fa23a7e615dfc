import { html, nothing } from "lit";
import { type MeasureInfo, measureText } from "../../specimen/measures";
import { fromWritten, writtenFor } from "../../targets/aim";
import { readTyped } from "../../ui/typed";
import { text } from "../messages.generated";
import type { Studio } from "../studio";
import { currentAims, searchTarget, shareDone, TARGET_SEARCH } from "../target_search";
import { StudioPart } from "./studio_part";

/** Form below a measure, in which the user requests another value. */
export class TargetForm extends StudioPart {
	static override properties = { ...StudioPart.properties, info: { attribute: false }, value: { attribute: false } };
	declare info: MeasureInfo;
	/** The measured value. */
	declare value: number;
	#problem = "";

	/** Returns the values whose change redraws the form. */
	protected override shows(studio: Studio): readonly unknown[] {
		return [studio.toolState(TARGET_SEARCH), studio.state.specimen];
	}

	/** Renders the field for a target value of a measure, the progress of its search, and the last result. */
	protected override draw(studio: Studio): unknown {
		const { info, value } = this;
		const { now } = studio.toolState(TARGET_SEARCH);
		const held = currentAims(studio).find(({ measure }) => measure === info.key);
		const unit = info.kind === "share" ? "%" : info.unit;
		const field = html`<input
			class="typed" name="value" type="text" inputmode="decimal" autocomplete="off" .value=${writtenFor(info, held?.value ?? value)}
			@focus=${(event: FocusEvent) => (event.target as HTMLInputElement).select()}
		>`;
		return html`<form class="ask" @submit=${this.#submit}>
			<label>${text.pieces("target_set", { field, unit })}</label>
			${
				now?.measure === info.key
					? html`<progress aria-label=${text("growing")} max="1" value=${shareDone(now)}></progress>
						<button class="button quiet" type="button" @click=${now.cancel}>${text("cancel")}</button>`
					: html`<button class="button" aria-label=${text("target_find_for", { measure: info.label })}>${text("target_find")}</button>`
			}
			${held ? html`<p>${text("target_shown", { value: measureText(info, held.value) })}</p>` : nothing}
			${this.#problem ? html`<p role="alert">${this.#problem}</p>` : nothing}
		</form>`;
	}

	/** Moves the focus to the field. */
	async enter(): Promise<void> {
		await this.updateComplete;
		this.querySelector("input")?.focus();
	}

	/** Starts the search for the typed value, or reports that it is no valid one. */
	#submit(event: SubmitEvent): void {
		event.preventDefault();
		const typed = readTyped(String(new FormData(event.target as HTMLFormElement).get("value")));
		const right = Number.isFinite(typed) && typed >= 0;
		this.#problem = right ? "" : text("target_invalid");
		this.requestUpdate();
		if (right) void searchTarget(this.context, { measure: this.info.key, value: fromWritten(this.info, typed) });
	}
}

customElements.define("panicle-ask", TargetForm);
