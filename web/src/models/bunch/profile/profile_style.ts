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
		overflow: visible;
		user-select: none;
		-webkit-user-select: none;
	}
	path,
	line,
	circle {
		vector-effect: non-scaling-stroke;
	}
	canvas {
		position: absolute;
		width: 100%;
		height: 100%;
		opacity: 0.34;
		/* So short that nobody sees it: its end tells the view that the theme has changed. */
		transition: color 1ms;
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
	.symbol {
		font: italic 400 1.25em / 0 var(--serif, Georgia, "Times New Roman", serif);
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
		position: absolute;
		left: -22px;
		top: -22px;
		width: 44px;
		height: 44px;
		margin: 0;
		padding: 0;
		border: 0;
		border-radius: 50%;
		outline: none;
		background: none;
		color: inherit;
		font: inherit;
		line-height: 1;
		cursor: grab;
		touch-action: none;
		user-select: none;
		-webkit-user-select: none;
		-webkit-touch-callout: none;
		-webkit-tap-highlight-color: transparent;
	}
	.handle::before,
	.handle::after {
		content: "";
		position: absolute;
		inset: 0;
		margin: auto;
		box-sizing: border-box;
		border-radius: 50%;
	}
	.handle::before {
		--face: var(--ground);
		--core: var(--grip);
		width: 14px;
		height: 14px;
		border: 1.75px solid var(--grip);
		background: radial-gradient(circle, var(--core) 2px, var(--face) 2.6px);
	}
	.handle::after {
		width: 23px;
		height: 23px;
	}
	.handle:hover::before {
		--face: color-mix(in srgb, var(--grip) 22%, var(--ground));
	}
	.handle.held::before {
		--face: var(--grip);
		--core: var(--ground);
	}
	:not(.pointed) > .handle:focus-visible::after {
		border: 2px solid var(--grip);
	}
	.handle .name {
		line-height: 1.2;
		position: absolute;
		top: 1px;
		left: 50%;
		translate: calc(-50% + var(--aside));
		text-shadow:
			0 0 2px var(--ground),
			0 0 2px var(--ground),
			0 0 3px var(--ground);
		pointer-events: none;
	}
	.handle[data-handle="p2"] .name {
		top: 17px;
		left: 33px;
		translate: none;
	}
	sub {
		font-size: 0.75em;
		line-height: 0;
	}
	.handle:is(:hover, :focus-visible, .held) .name {
		opacity: 1;
	}
	.dragging,
	.dragging .handle {
		cursor: grabbing;
	}
	.handle:disabled {
		opacity: 0.4;
		cursor: default;
		touch-action: auto;
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
		.handle::before {
			forced-color-adjust: none;
			--ground: Canvas;
			--grip: Highlight;
		}
		.guide {
			stroke: Highlight;
		}
	}
`;
