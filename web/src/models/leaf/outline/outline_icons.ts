import { html, svg } from "lit";

/** Line drawings on a 20 × 20 grid. */
const drawing = (path: unknown) => html`<svg viewBox="0 0 20 20" aria-hidden="true">${path}</svg>`;

export const LOCK = drawing(svg`<path d="M10 2.5v15M7.5 6 3.5 10l4 4M12.5 6l4 4-4 4"/>`);
export const TURN = drawing(
	svg`<path d="M3 15c4 0 3.5-9 7-9s3 9 7 9"/><path d="M7.8 3.8h4.4v4.4H7.8z" fill="currentColor"/>`,
);
export const ADD = drawing(svg`<path d="M10 4.5v11M4.5 10h11"/>`);
export const REMOVE = drawing(svg`<path d="M4.5 10h11"/>`);
