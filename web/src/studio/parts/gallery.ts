import { html } from "lit";
import { PRESETS } from "../../specimen/presets/index";
import type { Studio } from "../studio";
import { isDark } from "../theme";
import { StudioElement } from "./studio_element";

/** Rendered by the app itself on the paper of each theme (`npm run gallery`). */
const pictureOf = (name: string, dark: boolean) =>
	`${import.meta.env.BASE_URL}gallery/${name}-${dark ? "dark" : "light"}.webp`;

/** The presets as small pictures; choosing one is one undo step. */
export class Gallery extends StudioElement {
	protected override draw(studio: Studio): unknown {
		const { specimen, ui } = studio.state;
		const chosen = specimen.preset;
		const dark = isDark(ui.theme);
		return html`<ul>
			${PRESETS.map(
				({ name, title, figure, about }) => html`<li>
					<button
						class="preset" type="button" aria-current=${name === chosen} title="${about} (figure ${figure})" data-preset=${name}
						@click=${() => studio.choosePreset(name)}
					>
						<img src=${pictureOf(name, dark)} alt="" width="60" height="75" loading="lazy" decoding="async">${title}
					</button>
				</li>`,
			)}
		</ul>`;
	}
}

customElements.define("panicle-gallery", Gallery);
