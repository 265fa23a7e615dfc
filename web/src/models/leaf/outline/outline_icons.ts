import { html, svg } from "lit";

/** Wraps the elements of a line drawing in an SVG of 20 × 20 units. */
const iconOf = (path: unknown) => html`<svg viewBox="0 0 20 20" aria-hidden="true">${path}</svg>`;

export const LOCK = iconOf(svg`<path d="M10 2.5v15M7.5 6 3.5 10l4 4M12.5 6l4 4-4 4"/>`);
export const TURN = iconOf(
	svg`<path d="M3 15c4 0 3.5-9 7-9s3 9 7 9"/><path d="M7.8 3.8h4.4v4.4H7.8z" fill="currentColor"/>`,
);
export const ADD = iconOf(svg`<path d="M10 4.5v11M4.5 10h11"/>`);
export const REMOVE = iconOf(svg`<path d="M4.5 10h11"/>`);
