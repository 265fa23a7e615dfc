import { html, nothing } from "lit";
import { type MeasureInfo, measureText } from "../../specimen/measures";
import { fromWritten, writtenFor } from "../../targets/aim";
import { readTyped } from "../../ui/typed";
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

	protected override shows(studio: Studio): readonly unknown[] {
		return [studio.toolState(TARGET_SEARCH), studio.state.specimen];
	}

	protected override draw(studio: Studio): unknown {
		const { info, value } = this;
		const { now } = studio.toolState(TARGET_SEARCH);
		const held = currentAims(studio).find(({ measure }) => measure === info.key);
		const unit = info.kind === "share" ? "%" : info.unit;
		return html`<form class="ask" @submit=${this.#submit}>
			<label>Ask for <input
				class="typed" name="value" type="text" inputmode="decimal" autocomplete="off" .value=${writtenFor(info, held?.value ?? value)}
				@focus=${(event: FocusEvent) => (event.target as HTMLInputElement).select()}
			> ${unit}</label>
			${
				now?.measure === info.key
					? html`<progress aria-label="Growing" max="1" value=${shareDone(now)}></progress>
						<button class="button quiet" type="button" @click=${now.cancel}>Cancel</button>`
					: html`<button class="button" aria-label="Ask for this ${info.label.toLowerCase()}">Ask</button>`
			}
			${held ? html`<p>${measureText(info, held.value)} asked; held while another is asked for.</p>` : nothing}
			${this.#problem ? html`<p role="alert">${this.#problem}</p>` : nothing}
		</form>`;
	}

	/** Moves the focus to the field. */
	async enter(): Promise<void> {
		await this.updateComplete;
		this.querySelector("input")?.focus();
	}

	#submit(event: SubmitEvent): void {
		event.preventDefault();
		const text = String(new FormData(event.target as HTMLFormElement).get("value"));
		const typed = readTyped(text);
		const right = Number.isFinite(typed) && typed >= 0;
		this.#problem = right ? "" : `“${text.slice(0, 20)}” is no number that can be asked for.`;
		this.requestUpdate();
		if (right) void searchTarget(this.context, { measure: this.info.key, value: fromWritten(this.info, typed) });
	}
}

customElements.define("panicle-ask", TargetForm);
