/** The pictures of the help: drawings in the page's colours, and pictures of presets. */
import { html, nothing } from "lit";
import type { Family } from "../../specimen/presets";
import { firstOf } from "../home/families";
import type { SectionKey } from "./sections";

/** Families whose first plant a section shows in a picture. */
export const FAMILIES: Readonly<Partial<Record<SectionKey, readonly Family[]>>> = {
	start: ["grapes", "gardens"],
	find: ["trees", "flowers", "leaves", "roots"],
};

/** Draws an outline with its points; one of them is being dragged. */
const shape = () => html`<svg viewBox="0 0 160 120" aria-hidden="true">
	<path class="faint" d="M72 8v104" stroke-dasharray="7 3 1 3" />
	<path d="M72 14C36 18 30 44 44 70 52 86 64 98 72 108" />
	<path d="M72 14c46 2 62 20 50 44-6 16-30 38-50 50" />
	<path class="accent" d="M126 44h22m-6-5 6 5-6 5" />
	<g class="point"><circle cx="38" cy="40" r="5" /><circle cx="50" cy="80" r="5" /><circle cx="98" cy="84" r="5" /></g>
	<circle class="point held" cx="119" cy="44" r="6" />
</svg>`;

/** Draws a bunch with an arrow around it. */
const view = () => html`<svg viewBox="0 0 160 120" aria-hidden="true">
	<path d="M80 26V8" />
	<g class="fruit">
		<circle cx="66" cy="34" r="11" /><circle cx="88" cy="32" r="11" /><circle cx="108" cy="40" r="10" />
		<circle cx="56" cy="52" r="10" /><circle cx="78" cy="53" r="12" /><circle cx="99" cy="58" r="11" />
		<circle cx="70" cy="74" r="11" /><circle cx="90" cy="78" r="10" /><circle cx="79" cy="95" r="9" />
	</g>
	<path class="accent" d="M28 62c-12 26 22 42 56 42 34 0 62-14 50-38m-7 6 7-7 6 8" />
</svg>`;

/** Draws three stages of a plant over the slider of its age. */
const growth = () => html`<svg viewBox="0 0 160 120" aria-hidden="true">
	<path d="M30 84V72m0 4c-6 0-9-3-9-8 6 0 9 3 9 8zm0-2c5 0 8-3 8-7-5 0-8 2-8 7z" />
	<path d="M76 84V50m0 20c-9 0-13-4-13-11 9 0 13 4 13 11zm0-8c8 0 12-4 12-10-8 0-12 4-12 10zm0-12c-6-2-8-6-6-12 6 2 8 6 6 12z" />
	<path d="M126 84V46m0 24 12-12m-12 4-12-12" /><path d="M126 46c-20 4-30-10-20-20 0-14 22-18 28-6 16-2 18 18 6 22-2 4-8 5-14 4z" />
	<path class="faint" d="M40 104h108" /><path class="accent" d="M40 104h56" />
	<circle class="point held" cx="96" cy="104" r="6" /><path class="accent solid" d="M12 96v16l14-8z" />
</svg>`;

/** Draws a page with a plant, from which a link and a file come. */
const files = () => html`<svg viewBox="0 0 160 120" aria-hidden="true">
	<rect x="14" y="20" width="58" height="80" rx="5" /><path d="M43 84V52m0 18c-9 0-13-4-13-11 9 0 13 4 13 11zm0-8c8 0 12-4 12-10-8 0-12 4-12 10z" />
	<path class="accent" d="M80 46h24m-6-5 6 5-6 5M80 78h24m-6-5 6 5-6 5" />
	<rect x="112" y="36" width="36" height="20" rx="10" /><path d="M122 46h16" />
	<path d="M116 66h20l8 8v22h-28zM136 66v8h8" />
</svg>`;

/** Draws three keys. */
const keyboard = () => html`<svg viewBox="0 0 160 120" aria-hidden="true">
	<rect x="16" y="40" width="40" height="40" rx="6" /><rect x="64" y="40" width="40" height="40" rx="6" /><rect x="112" y="40" width="34" height="40" rx="6" />
	<path class="accent" d="M28 60h16m-6-5 6 5-6 5M84 68V52m-5 6 5-6 5 6M122 60h14m-9-5-5 5 5 5" />
</svg>`;

const DRAWINGS: Readonly<Partial<Record<SectionKey, () => unknown>>> = { shape, view, growth, files, keyboard };

/** Renders the pictures of a section. @param dark whether the page's theme is dark */
export function picturesOf(section: SectionKey, dark: boolean): unknown {
	const families = FAMILIES[section] ?? [];
	const drawing = DRAWINGS[section];
	if (families.length === 0 && !drawing) return nothing;
	const picture = ({ model, preset }: ReturnType<typeof firstOf>) => html`<img
		src="${import.meta.env.BASE_URL}gallery/${model}/${preset}-${dark ? "dark" : "light"}.webp" alt="" width="60" height="75" loading="lazy" decoding="async"
	>`;
	return html`<div class="help-picture">${drawing ? drawing() : families.map(firstOf).map(picture)}</div>`;
}
