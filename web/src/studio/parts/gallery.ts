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
	#revealed: string | undefined;

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
						<img src=${pictureOf(name, dark)} alt="" width="60" height="75" loading="lazy" fetchpriority="low" decoding="async">${title}
					</button>
				</li>`,
			)}
		</ul>`;
	}

	/** The chosen preset is in sight, also when a link or a file has chosen it. */
	protected override updated(): void {
		const { preset } = this.studio.state.specimen;
		const strip = this.querySelector("ul");
		const chosen = this.querySelector<HTMLElement>("[aria-current=true]");
		if (this.#revealed === preset || !strip || !chosen) return;
		this.#revealed = preset;
		reveal(strip, chosen);
	}
}

/** Scrolls the strip, and nothing else, until the preset is in it. */
function reveal(strip: HTMLElement, preset: HTMLElement): void {
	const left = preset.offsetLeft - strip.offsetLeft;
	const right = left + preset.offsetWidth;
	if (left < strip.scrollLeft) strip.scrollLeft = left;
	else if (right > strip.scrollLeft + strip.clientWidth) strip.scrollLeft = right - strip.clientWidth;
}

customElements.define("panicle-gallery", Gallery);
