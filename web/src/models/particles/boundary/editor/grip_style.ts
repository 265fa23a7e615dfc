import { css } from "lit";

/** Fine ink lines on the page's paper, one accent for what can be taken hold of. */
export const gripStyle = css`
	:host {
		--line: var(--ink, #2b2622);
		--ground: var(--paper, #faf6ee);
		--hold: var(--accent, #7b1e3a);
		display: block;
		position: relative;
		color: var(--line);
		font: 500 10.5px / 1 system-ui, sans-serif;
		font-variant-numeric: tabular-nums;
	}
	.field,
	svg,
	canvas {
		position: absolute;
		inset: 0;
		width: 100%;
		height: 100%;
		user-select: none;
		-webkit-user-select: none;
	}
	canvas {
		opacity: 0.5;
		/* So short that nobody sees it: its end tells the view that the theme has changed. */
		transition: color 1ms;
	}
	.outer {
		fill: color-mix(in srgb, var(--hold) 5%, transparent);
		stroke: currentColor;
		stroke-width: 1.1px;
		stroke-linejoin: round;
	}
	.inner {
		fill: none;
		stroke: color-mix(in srgb, currentColor 55%, transparent);
		stroke-width: 1px;
		stroke-dasharray: 2 3;
	}
	.ground {
		stroke: currentColor;
		stroke-width: 1px;
	}
	.axis {
		stroke: color-mix(in srgb, currentColor 45%, transparent);
		stroke-width: 0.8px;
		stroke-dasharray: 7 3 1 3;
	}
	.ring {
		fill: none;
		stroke: color-mix(in srgb, currentColor 35%, transparent);
		stroke-width: 0.8px;
	}
	.obstacle {
		fill: color-mix(in srgb, currentColor 14%, transparent);
		stroke: color-mix(in srgb, currentColor 50%, transparent);
		stroke-width: 0.8px;
	}
	.target {
		fill: currentColor;
	}
	.ray {
		stroke: var(--hold);
		stroke-width: 1px;
		stroke-dasharray: 3 2;
	}
	text {
		fill: currentColor;
		opacity: 0.66;
	}
	.scale {
		opacity: 0.6;
	}
	.scale line {
		stroke: currentColor;
		stroke-width: 1px;
	}
	.grip {
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
		cursor: grab;
		touch-action: none;
		user-select: none;
		-webkit-user-select: none;
		-webkit-touch-callout: none;
		-webkit-tap-highlight-color: transparent;
	}
	.grip::before,
	.grip::after {
		content: "";
		position: absolute;
		inset: 0;
		margin: auto;
		box-sizing: border-box;
		border-radius: 50%;
	}
	.grip::before {
		--face: var(--ground);
		--core: var(--hold);
		width: 14px;
		height: 14px;
		border: 1.75px solid var(--hold);
		background: radial-gradient(circle, var(--core) 2px, var(--face) 2.6px);
	}
	.grip::after {
		width: 23px;
		height: 23px;
	}
	.grip:hover::before {
		--face: color-mix(in srgb, var(--hold) 22%, var(--ground));
	}
	.grip.held::before {
		--face: var(--hold);
		--core: var(--ground);
	}
	:not(.pointed) > .grip:focus-visible::after {
		border: 2px solid var(--hold);
	}
	.grip .value {
		position: absolute;
		z-index: 1;
		top: 50%;
		left: 36px;
		translate: 0 -50%;
		padding: 3px 4px;
		border-radius: 3px;
		background: color-mix(in srgb, var(--ground) 85%, transparent);
		color: var(--hold);
		white-space: nowrap;
		pointer-events: none;
	}
	.grip .value.left {
		left: auto;
		right: 36px;
	}
	.dragging,
	.dragging .grip {
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
		.grip::before {
			forced-color-adjust: none;
			--ground: Canvas;
			--hold: Highlight;
		}
	}
`;
