import { html, type SVGTemplateResult, svg, type TemplateResult } from "lit";

/** Line icons on a 20 × 20 field, drawn with the page's stroke. */
const DRAWINGS = {
	undo: svg`<path d="M4 8h8.5a4 4 0 0 1 0 8H9M4 8l3.5-3.5M4 8l3.5 3.5"/>`,
	redo: svg`<path d="M16 8H7.5a4 4 0 0 0 0 8H11M16 8l-3.5-3.5M16 8l-3.5 3.5"/>`,
	reset: svg`<path d="M4.5 10a5.5 5.5 0 1 0 1.6-3.9L4.5 7.7M4.5 4v3.7h3.7"/>`,
	open: svg`<path d="M3 15.5v-11h5l2 2.5h6v2M3 15.5 5.5 9H18l-2.5 6.5z"/>`,
	saved: svg`<path d="M5.5 3.5h9v13L10 13l-4.5 3.5z"/>`,
	share: svg`<circle cx="5.5" cy="10" r="2.3"/><circle cx="14.5" cy="5" r="2.3"/><circle cx="14.5" cy="15" r="2.3"/><path d="m7.5 8.9 5-2.8M7.5 11.1l5 2.8"/>`,
	download: svg`<path d="M10 3v9.5M6.5 9.5 10 13l3.5-3.5M4 16.5h12"/>`,
	light: svg`<circle cx="10" cy="10" r="3.2"/><path d="M10 2.5v2M10 15.5v2M2.5 10h2M15.5 10h2M4.7 4.7l1.4 1.4M13.9 13.9l1.4 1.4M4.7 15.3l1.4-1.4M13.9 6.1l1.4-1.4"/>`,
	dark: svg`<path d="M16 12A6.5 6.5 0 0 1 8 4a6.5 6.5 0 1 0 8 8z"/>`,
	help: svg`<circle cx="10" cy="10" r="7"/><path d="M8 8.2a2 2 0 1 1 2.8 1.85c-.6.3-.8.6-.8 1.3M10 13.8v.1"/>`,
	keyboard: svg`<rect x="2.5" y="5" width="15" height="10" rx="1.5"/><path d="M5.5 8v.1M8.5 8v.1M11.5 8v.1M14.5 8v.1M7 12h6"/>`,
	info: svg`<circle cx="10" cy="10" r="7"/><path d="M10 9.3v4.4M10 6.3v.1"/>`,
	frame: svg`<path d="M3.5 7V3.5H7M13 3.5h3.5V7M16.5 13v3.5H13M7 16.5H3.5V13"/><circle cx="10" cy="10" r="2"/>`,
	again: svg`<rect x="3.5" y="3.5" width="13" height="13" rx="3"/><path d="M7 7v.1M13 7v.1M10 10v.1M7 13v.1M13 13v.1" stroke-width="2"/>`,
	play: svg`<path d="M6.5 4.2v11.6L16 10z" fill="currentcolor"/>`,
	pause: svg`<path d="M7 4.5v11M13 4.5v11" stroke-width="2.6"/>`,
	wind: svg`<path d="M2.5 8h9a2.3 2.3 0 1 0-2.2-3M2.5 11h13a2.3 2.3 0 1 1-2.2 3M2.5 14h6.5"/>`,
	step: svg`<path d="M5 4.8v10.4L12 10z" fill="currentcolor"/><path d="M15 4.8v10.4" stroke-width="2"/>`,
	scrub: svg`<path d="M6.5 6.5 3 10l3.5 3.5M13.5 6.5 17 10l-3.5 3.5M3 10h14"/>`,
	search: svg`<circle cx="8.5" cy="8.5" r="5"/><path d="m12.3 12.3 4.2 4.2"/>`,
	unfold: svg`<path d="m6 8 4 4 4-4"/>`,
	star: svg`<path d="m10 3.2 2.1 4.4 4.7.6-3.5 3.3.9 4.8-4.2-2.4-4.2 2.4.9-4.8-3.5-3.3 4.7-.6z"/>`,
	starred: svg`<path d="m10 3.2 2.1 4.4 4.7.6-3.5 3.3.9 4.8-4.2-2.4-4.2 2.4.9-4.8-3.5-3.3 4.7-.6z" fill="currentcolor"/>`,
	outdoors: svg`<circle cx="14" cy="6" r="2.3"/><path d="M2.5 15.5c3-4.5 6-4.5 8.5-1.5 2-2 4-2 6.5 1.5M2.5 15.5h15M14 2v.8M17.7 3.4l-.6.6M18 6h-.8"/>`,
	tape: svg`<path d="m3 13 10-10 4 4L7 17zM10.5 5.5 12 7M8 8l1.5 1.5M5.5 10.5 7 12"/>`,
	room: svg`<path d="M10 2.5 16 6v7l-6 3.5L4 13V6zM4 6l6 3.5L16 6M10 9.5v7"/>`,
	presentation: svg`<rect x="2.5" y="4" width="15" height="12" rx="1.5"/><path d="M8.3 7.3v5.4l4.2-2.7z" fill="currentcolor"/>`,
	scale: svg`<path d="M3 8v4h14V8M10 9.5V12"/>`,
	names: svg`<path d="M3 6.2h9.5L17 10l-4.5 3.8H3zM6 10h5"/>`,
	enlarge: svg`<path d="M12 3.5h4.5V8M8 16.5H3.5V12M16.5 3.5l-5 5M3.5 16.5l5-5"/>`,
	reduce: svg`<path d="M16 8.5h-4.5V4M4 11.5h4.5V16M11.5 8.5l5-5M8.5 11.5l-5 5"/>`,
	close: svg`<path d="m5.5 5.5 9 9M14.5 5.5l-9 9"/>`,
} satisfies Record<string, SVGTemplateResult>;

export type IconName = keyof typeof DRAWINGS;

/** Draws a decorative icon, from this list or a model's own; the button around it has the accessible name. */
export function icon(drawn: IconName | SVGTemplateResult): TemplateResult {
	const drawing = typeof drawn === "string" ? DRAWINGS[drawn] : drawn;
	return html`<svg class="icon-mark" viewBox="0 0 20 20" aria-hidden="true">${drawing}</svg>`;
}
