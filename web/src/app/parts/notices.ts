import { html, nothing } from "lit";
import { icon } from "../../ui/icons";
import type { Studio } from "../studio";
import type { Notice } from "../types";
import { StudioPart } from "./studio_part";

/** The notices, one below the other. */
export class Notices extends StudioPart {
	protected override shows({ state }: Studio): readonly unknown[] {
		return [state.notices];
	}

	protected override draw(studio: Studio): unknown {
		return html`<div class="notices" role="status">${studio.state.notices.map((notice) => drawNotice(studio, notice))}</div>`;
	}
}

function drawNotice(studio: Studio, { id, title, details, copy, again, act }: Notice): unknown {
	const offered = act ?? (again && { words: "Try again", run: again });
	const take = () => {
		studio.dismiss(id);
		offered?.run();
	};
	return html`<section class="notice">
		<div>
			${title}
			${details.length > 0 ? html`<ul>${details.map((line) => html`<li>${line}</li>`)}</ul>` : nothing}
			${
				copy === undefined
					? nothing
					: html`<input readonly aria-label="Link to copy" .value=${copy} @focus=${(event: Event) => (event.target as HTMLInputElement).select()}>`
			}
		</div>
		${offered ? html`<button class="button" type="button" @click=${take}>${offered.words}</button>` : nothing}
		<button class="button quiet icon" type="button" aria-label="Dismiss" @click=${() => studio.dismiss(id)}>${icon("close")}</button>
	</section>`;
}

customElements.define("panicle-notices", Notices);
