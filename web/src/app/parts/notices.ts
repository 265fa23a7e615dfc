import { html, nothing } from "lit";
import { icon } from "../../ui/icons";
import { text } from "../messages.generated";
import type { Studio } from "../studio";
import type { Notice } from "../types";
import { StudioPart } from "./studio_part";

/** The notices, one below the other. */
export class Notices extends StudioPart {
	/** Returns the values whose change redraws the notices. */
	protected override shows({ state }: Studio): readonly unknown[] {
		return [state.notices];
	}

	/** Renders all notices. */
	protected override draw(studio: Studio): unknown {
		return html`<div class="notices" role="status">${studio.state.notices.map((notice) => drawNotice(studio, notice))}</div>`;
	}
}

/** Renders a notice. Its button runs `act`, or else tries again; both dismiss the notice. */
function drawNotice(studio: Studio, { id, title, details, again, act }: Notice): unknown {
	const offered = act ?? (again && { label: text("try_again"), run: again });
	const take = () => {
		studio.dismiss(id);
		offered?.run();
	};
	return html`<section class="notice">
		<div>
			${title}
			${details.length > 0 ? html`<ul>${details.map((line) => html`<li>${line}</li>`)}</ul>` : nothing}
		</div>
		${offered ? html`<button class="button" type="button" @click=${take}>${offered.label}</button>` : nothing}
		<button class="button quiet icon" type="button" aria-label=${text("notice_dismiss")} @click=${() => studio.dismiss(id)}>${icon("close")}</button>
	</section>`;
}

customElements.define("panicle-notices", Notices);
