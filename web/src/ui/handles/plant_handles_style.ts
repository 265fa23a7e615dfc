/** Style of handles over the picture and of the lines between them, with the element's colours, or else the page's. */
export const HANDLES_STYLE = `
	.plant-handles { position: absolute; pointer-events: none; overflow: hidden; }
	.plant-handles svg { position: absolute; inset: 0; width: 100%; height: 100%; fill: none; stroke: var(--panicle-ink, var(--ink)); stroke-opacity: 0.45; }
	.plant-handles button {
		position: absolute;
		top: -16px;
		left: -16px;
		width: 32px;
		height: 32px;
		padding: 0;
		border: 0;
		border-radius: 50%;
		background: radial-gradient(circle, var(--panicle-focus, var(--wine)) 5px, var(--panicle-paper, var(--paper)) 5.5px 7px, transparent 7.5px);
		cursor: grab;
		pointer-events: auto;
		touch-action: none;
	}
	.plant-handles button[data-kind="size"] { border-radius: 0; background: conic-gradient(var(--panicle-focus, var(--wine)) 0 0) center / 9px 9px no-repeat, conic-gradient(var(--panicle-paper, var(--paper)) 0 0) center / 13px 13px no-repeat; }
	.plant-handles button[data-kind="turn"] { background: radial-gradient(circle, var(--panicle-paper, var(--paper)) 3px, var(--panicle-focus, var(--wine)) 3.5px 5.5px, var(--panicle-paper, var(--paper)) 6px 7px, transparent 7.5px); }
	.plant-handles button[data-kind="chosen"] { background: radial-gradient(circle, var(--panicle-focus, var(--wine)) 7px, var(--panicle-paper, var(--paper)) 7.5px 9px, transparent 9.5px); }
	.plant-handles button:active { cursor: grabbing; }
	.plant-handles button:focus-visible { outline: 2px solid var(--panicle-focus, var(--wine)); outline-offset: -7px; }
	@media (pointer: coarse) { .plant-handles button { top: -22px; left: -22px; width: 44px; height: 44px; } }
	@media (forced-colors: active) { .plant-handles button { forced-color-adjust: none; background: radial-gradient(circle, ButtonText 6px, ButtonFace 6.5px 8px, transparent 8.5px); } }
`;
