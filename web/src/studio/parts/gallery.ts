import { html } from "lit";
import { PRESETS, type Preset, type PresetKind } from "../../models/bunch/presets/index";
import type { Studio } from "../studio";
import { isDark } from "../theme";
import { StudioElement } from "./studio_element";

/** Rendered by the app itself on the paper of each theme (`npm run gallery`). */
const pictureOf = (name: string, dark: boolean) =>
	`${import.meta.env.BASE_URL}gallery/${name}-${dark ? "dark" : "light"}.webp`;

const SECTIONS: readonly (readonly [PresetKind, string])[] = [
	["shape", "Shapes"],
	["variety", "Varieties"],
	["fruit", "Other fruits"],
];

/** The presets as small pictures, by kind; choosing one is one undo step. */
export class Gallery extends StudioElement {
	#revealed: string | undefined;

	protected override draw(studio: Studio): unknown {
		const { specimen, ui } = studio.state;
		const dark = isDark(ui.theme);
		const item = (preset: Preset) => html`<li>
			<button
				class="preset" type="button" aria-current=${preset.name === specimen.preset} title=${described(preset)} data-preset=${preset.name}
				@click=${() => studio.choosePreset(preset.name)}
			>
				<img src=${pictureOf(preset.name, dark)} alt="" width="60" height="75" loading="lazy" fetchpriority="low" decoding="async">${preset.title}
			</button>
		</li>`;
		return html`<div class="strip">${SECTIONS.map(
			([kind, title]) => html`<section aria-labelledby="presets-${kind}">
				<h2 id="presets-${kind}">${title}</h2>
				<ul>${PRESETS.filter((preset) => preset.kind === kind).map(item)}</ul>
			</section>`,
		)}</div>`;
	}

	/** The chosen preset is in sight, also when a link or a file has chosen it. */
	protected override updated(): void {
		const { preset } = this.studio.state.specimen;
		const strip = this.querySelector<HTMLElement>(".strip");
		const chosen = this.querySelector<HTMLElement>("[aria-current=true]");
		if (this.#revealed === preset || !strip || !chosen) return;
		this.#revealed = preset;
		reveal(strip, chosen);
	}
}

function described({ about, figure }: Preset): string {
	return figure === undefined ? about : `${about} (figure ${figure})`;
}

/** Scrolls the strip, and nothing else, until the preset is in it. */
function reveal(strip: HTMLElement, preset: HTMLElement): void {
	const box = preset.getBoundingClientRect();
	const shown = strip.getBoundingClientRect();
	if (box.left < shown.left) strip.scrollLeft -= shown.left - box.left;
	else if (box.right > shown.right) strip.scrollLeft += box.right - shown.right;
}

customElements.define("panicle-gallery", Gallery);
