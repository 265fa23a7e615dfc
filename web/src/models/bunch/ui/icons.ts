import { svg } from "lit";

/** Icons: line drawings on a 20 × 20 grid (ui/icons.ts). */
export const STEMS = svg`<path d="M10 2.5V17M10 6l4.5 3M10 6 5.5 9M10 10.5l3.5 2.5M10 10.5 6.5 13"/>`;
export const OCTAHEDRON = svg`<path d="M10 2.5 16 9l-6 8.5L4 9zM4 9l6 2.5L16 9M10 2.5v9M10 11.5v6"/>`;
export const MIRROR = svg`<path d="M10 3v14M7.5 6 3 10l4.5 4zM12.5 6l4.5 4-4.5 4z"/>`;
export const THIN = svg`<circle cx="5" cy="5.5" r="2.2"/><circle cx="5" cy="14.5" r="2.2"/><path d="m6.9 6.8 9.6 7M6.9 13.2l9.6-7"/>`;
export const FLOWER = svg`<circle cx="10" cy="10" r="1.8"/><path d="M10 8.2V3.5M11.7 9.4l4.5-1.5M11.1 11.5l2.7 3.8M8.9 11.5l-2.7 3.8M8.3 9.4 3.8 7.9"/><circle cx="10" cy="3" r="1"/><circle cx="16.7" cy="7.7" r="1"/><circle cx="14.1" cy="15.8" r="1"/><circle cx="5.9" cy="15.8" r="1"/><circle cx="3.3" cy="7.7" r="1"/>`;
export const LEAF = svg`<path d="M2.5 4.5h15M10 4.5v2.5M10 17.5c-3.5-1-5.5-3-6-6l2 .3c-.4-1.6-.2-3 .6-4.3L8.5 9 10 7l1.5 2 1.9-1.5c.8 1.3 1 2.7.6 4.3l2-.3c-.5 3-2.5 5-6 6z"/>`;
