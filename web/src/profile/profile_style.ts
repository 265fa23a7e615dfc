import { css } from "lit";

/**
 * The look of a view: fine ink lines on the page's paper, one accent for what can be taken hold of. The page's
 * theme reaches in through --ink, --paper and --accent; what stands here is for a page without them.
 */
export const profileStyle = css`
	:host {
		--line: var(--ink, #2b2622);
		--ground: var(--paper, #faf6ee);
		--grip: var(--accent, #7b1e3a);
		display: block;
		position: relative;
		aspect-ratio: 1;
		color: var(--line);
		font: 500 10.5px / 1 system-ui, sans-serif;
		font-variant-numeric: tabular-nums;
	}
	:host([hidden]) {
		display: none;
	}
	svg {
		position: absolute;
		inset: 0;
		width: 100%;
		height: 100%;
		user-select: none;
		-webkit-user-select: none;
		-webkit-tap-highlight-color: transparent;
	}
	svg.dragging,
	svg.dragging * {
		cursor: grabbing;
	}
	path,
	line,
	circle {
		vector-effect: non-scaling-stroke;
	}
	.bunch {
		opacity: 0.34;
	}
	.bunch path {
		fill: none;
		stroke: currentColor;
		stroke-width: 1px;
		stroke-linecap: round;
	}
	.bunch circle {
		fill: var(--ground);
		stroke: currentColor;
		stroke-width: 0.8px;
	}
	.envelope {
		fill: color-mix(in srgb, var(--grip) 5%, transparent);
		stroke: color-mix(in srgb, var(--grip) 45%, transparent);
		stroke-width: 1px;
		stroke-dasharray: 1 3;
		stroke-linecap: round;
	}
	.outline {
		fill: none;
		stroke: currentColor;
		stroke-width: 1.1px;
		stroke-linejoin: round;
	}
	.axis {
		stroke: color-mix(in srgb, currentColor 45%, transparent);
		stroke-width: 0.8px;
		stroke-dasharray: 7 3 1 3;
	}
	.root {
		fill: currentColor;
	}
	.guide {
		stroke: var(--grip);
		stroke-width: 1px;
		stroke-dasharray: 3 2;
	}
	text {
		fill: currentColor;
		stroke: var(--ground);
		stroke-width: 3px;
		stroke-linejoin: round;
		paint-order: stroke;
		pointer-events: none;
	}
	.name {
		opacity: 0.66;
	}
	.subscript {
		font-size: 0.75em;
	}
	.value {
		fill: var(--grip);
	}
	.scale line {
		stroke: currentColor;
		stroke-width: 1px;
	}
	.scale {
		opacity: 0.6;
	}

	.handle {
		outline: none;
		cursor: grab;
	}
	.reach {
		fill: transparent;
		touch-action: none;
	}
	.dot {
		fill: var(--ground);
		stroke: var(--grip);
		stroke-width: 1.75px;
		pointer-events: none;
	}
	.core {
		fill: var(--grip);
		pointer-events: none;
	}
	.ring {
		fill: none;
		stroke: none;
		pointer-events: none;
	}
	.handle:hover .dot {
		fill: color-mix(in srgb, var(--grip) 22%, var(--ground));
	}
	.handle.held .dot {
		fill: var(--grip);
	}
	.handle.held .core {
		fill: var(--ground);
	}
	.handle:focus-visible .ring {
		stroke: var(--grip);
		stroke-width: 2px;
	}
	.handle:focus-visible .name,
	.handle:hover .name,
	.handle.held .name {
		opacity: 1;
	}
	:host([disabled]) .handle,
	:host([disabled]) .reach {
		cursor: default;
		touch-action: auto;
	}
	:host([disabled]) .handles {
		opacity: 0.4;
	}
	.spoken {
		position: absolute;
		width: 1px;
		height: 1px;
		margin: 0;
		overflow: hidden;
		clip-path: inset(50%);
		white-space: nowrap;
	}
	@media (forced-colors: active) {
		.dot,
		.guide,
		.handle:focus-visible .ring {
			stroke: Highlight;
		}
		.core {
			fill: Highlight;
		}
	}
`;
