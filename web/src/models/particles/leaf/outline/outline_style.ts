import { css } from "lit";

/** Fine ink lines on the page's paper, one accent for what can be taken hold of; the page's theme reaches in. */
export const outlineStyle = css`
	:host {
		--line: var(--ink, #2b2622);
		--ground: var(--paper, #faf6ee);
		--grip: var(--accent, #7b1e3a);
		display: block;
		position: relative;
		color: var(--line);
		font: 500 10.5px / 1 system-ui, sans-serif;
		font-variant-numeric: tabular-nums;
	}
	:host([hidden]) {
		display: none;
	}
	.view {
		position: absolute;
		inset: 0 0 40px;
		user-select: none;
		-webkit-user-select: none;
	}
	canvas {
		position: absolute;
		width: 100%;
		height: 100%;
		/* So short that nobody sees it: its end tells the view that the theme has changed. */
		transition: color 1ms;
	}
	.scale {
		position: absolute;
		left: 8px;
		bottom: 4px;
		box-sizing: border-box;
		height: 14px;
		border: solid;
		border-width: 0 1px 1px;
		clip-path: polygon(0 9px, 1px 9px, 1px 0, calc(100% - 1px) 0, calc(100% - 1px) 9px, 100% 9px, 100% 100%, 0 100%);
		text-align: center;
		opacity: 0.7;
		pointer-events: none;
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
		outline: none;
		background: none;
		color: inherit;
		cursor: grab;
		touch-action: none;
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
		width: 8px;
		height: 8px;
		border: 1.5px solid var(--grip);
		background: var(--ground);
	}
	.handle[data-kind="corner"]::before {
		border-radius: 0;
	}
	.handle[data-kind="lobe"]::before,
	.handle[data-kind="pointed"]::before {
		width: 9px;
		height: 9px;
		background: var(--grip);
	}
	.handle[data-kind="pointed"]::before {
		width: 8px;
		height: 8px;
		border-radius: 0;
		rotate: 45deg;
	}
	.handle::after {
		width: 20px;
		height: 20px;
	}
	.handle.chosen::after {
		border: 1.25px solid color-mix(in srgb, var(--grip) 55%, transparent);
	}
	.handle:hover::before {
		scale: 1.3;
	}
	.handle.held::before {
		scale: 1.4;
		background: var(--grip);
	}
	.view:not(.pointed) > .handle:focus-visible::after {
		border: 2px solid var(--grip);
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
	.bar {
		position: absolute;
		inset: auto 0 0;
		display: flex;
		gap: 4px;
		height: 36px;
	}
	.bar button {
		flex: 1;
		min-width: 0;
		max-width: 56px;
		padding: 0;
		border: 1px solid color-mix(in srgb, currentColor 22%, transparent);
		border-radius: 6px;
		background: none;
		color: inherit;
		cursor: pointer;
	}
	.bar button:hover:not(:disabled) {
		border-color: var(--grip);
		color: var(--grip);
	}
	.bar button[aria-pressed="true"] {
		background: color-mix(in srgb, var(--grip) 14%, transparent);
		border-color: color-mix(in srgb, var(--grip) 60%, transparent);
		color: var(--grip);
	}
	.bar button:focus-visible {
		outline: 2px solid var(--grip);
		outline-offset: 1px;
	}
	.bar button:disabled {
		opacity: 0.4;
		cursor: default;
	}
	.bar svg {
		width: 20px;
		height: 20px;
		fill: none;
		stroke: currentColor;
		stroke-width: 1.4;
		stroke-linecap: round;
		stroke-linejoin: round;
	}
	@media (pointer: coarse) {
		.view {
			inset: 0 0 50px;
		}
		.bar {
			height: 44px;
		}
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
