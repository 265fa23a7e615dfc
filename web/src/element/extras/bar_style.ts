/** The style of the bar, which reduces the view's height. */
export const BAR_STYLE = `
	:host { --panicle-bar: 44px; }
	.bar {
		position: absolute;
		inset: auto 0 0;
		display: flex;
		align-items: center;
		gap: 2px;
		box-sizing: border-box;
		height: var(--panicle-bar);
		padding: 0 4px;
		container-type: inline-size;
	}
	.bar :is(button, a) {
		flex: none;
		display: grid;
		place-items: center;
		width: 36px;
		height: 36px;
		padding: 0;
		border: 0;
		border-radius: 6px;
		background: none;
		color: inherit;
		cursor: pointer;
	}
	.bar :is(button, a):hover { background: color-mix(in srgb, currentcolor 10%, transparent); }
	.bar button[aria-pressed="true"] { color: var(--panicle-focus); }
	.bar :focus-visible { outline: 2px solid var(--panicle-focus); outline-offset: -2px; }
	.bar svg { width: 20px; height: 20px; fill: none; stroke: currentcolor; stroke-width: 1.5; stroke-linecap: round; stroke-linejoin: round; }
	.bar label { display: contents; }
	.bar input { box-sizing: border-box; min-width: 24px; height: 28px; margin: 0; accent-color: var(--panicle-focus); font: inherit; }
	.bar input[type="range"] { flex: 1 1 60px; }
	.bar input[type="number"] {
		flex: 0 1 76px;
		padding: 0 6px;
		border: 1px solid color-mix(in srgb, currentcolor 35%, transparent);
		border-radius: 6px;
		background: none;
		color: inherit;
	}
	.bar .space { flex: 1; }
	.bar p:not(.unseen) { bottom: var(--panicle-bar); }
	@container (width < 210px) { .bar input[type="number"] { display: none; } }
	@container (width < 150px) { .bar input[type="range"] { display: none; } }
`;
