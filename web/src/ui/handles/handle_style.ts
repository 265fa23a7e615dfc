import { css } from "lit";

/**
 * Style of flat views: ink lines on the page's paper, and an accent colour for draggable elements. The page's theme
 * sets --ink, --paper and --accent; the defaults are for pages without a theme.
 */
export const handleStyle = css`
	:host {
		--line: var(--ink, #2b2622);
		--ground: var(--paper, #faf6ee);
		--grip: var(--accent, #7b1e3a);
		display: block;
		position: relative;
		color: var(--line);
		font: 500 12px / 1 system-ui, sans-serif;
		font-variant-numeric: tabular-nums;
	}
	:host([hidden]) {
		display: none;
	}
	.field,
	svg.drawing {
		position: absolute;
		inset: 0;
		user-select: none;
		-webkit-user-select: none;
	}
	svg.drawing {
		width: 100%;
		height: 100%;
	}
	canvas {
		position: absolute;
		width: 100%;
		height: 100%;
		/* So short that nobody sees it: its end tells the view that the theme has changed. */
		transition: color 1ms;
	}
	text {
		fill: currentColor;
	}
	.axis {
		stroke: color-mix(in srgb, currentColor 45%, transparent);
		stroke-width: 0.8px;
		stroke-dasharray: 7 3 1 3;
	}
	.scale {
		opacity: 0.75;
	}
	.scale line {
		stroke: currentColor;
		stroke-width: 1px;
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
	.field:not(.pointed) > .handle:focus-visible::after {
		border: 2px solid var(--grip);
	}
	.dragging,
	.dragging .handle {
		cursor: grabbing;
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
	}
`;
