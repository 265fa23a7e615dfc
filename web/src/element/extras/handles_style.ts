/** Handles over the picture, and the lines between them. */
export const HANDLES_STYLE = `
	.handles { pointer-events: none; overflow: hidden; }
	.handles svg { position: absolute; inset: 0; width: 100%; height: 100%; fill: none; stroke: var(--panicle-ink); stroke-opacity: 0.45; }
	.handles button {
		position: absolute;
		top: -16px;
		left: -16px;
		width: 32px;
		height: 32px;
		padding: 0;
		border: 0;
		border-radius: 50%;
		background: radial-gradient(circle, var(--panicle-focus) 5px, var(--panicle-paper) 5.5px 7px, transparent 7.5px);
		cursor: grab;
		pointer-events: auto;
		touch-action: none;
	}
	.handles button:active { cursor: grabbing; }
	.handles button:focus-visible { outline: 2px solid var(--panicle-focus); outline-offset: -7px; }
	@media (pointer: coarse) { .handles button { top: -22px; left: -22px; width: 44px; height: 44px; } }
	@media (forced-colors: active) { .handles button { forced-color-adjust: none; background: radial-gradient(circle, ButtonText 6px, ButtonFace 6.5px 8px, transparent 8.5px); } }
`;
