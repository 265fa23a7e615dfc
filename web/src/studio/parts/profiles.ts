import { html } from "lit";
import type { ProfileEvent } from "../../models/bunch/profile/profile_view";
import type { Studio } from "../studio";
import { StudioElement } from "./studio_element";
import "../../models/bunch/profile/profile_view";

const VIEWS = [
	["front", "Front"],
	["side", "Side"],
] as const;

/** The front and the side view of the profile with their handles. */
export class Profiles extends StudioElement {
	protected override draw(studio: Studio): unknown {
		return VIEWS.map(
			([view, title]) => html`<section class="profile" data-side=${view} aria-label="${title} view">
				<h2>${title}</h2>
				<panicle-profile
					view=${view} .parameters=${studio.state.specimen.parameters} .locks=${studio.state.ui.locks}
					.berries=${studio.state.grown} .initial=${studio.preset.parameters}
					@profile-input=${({ detail }: ProfileEvent) => studio.edit(detail)}
					@profile-change=${() => studio.settle()} @profile-cancel=${() => studio.settle()}
				></panicle-profile>
			</section>`,
		);
	}
}

customElements.define("panicle-profiles", Profiles);
