/** The element's default style. Pages may set its size, the custom properties below and the style of `::part(…)`. */
export const ELEMENT_STYLE = `
	:host {
		--panicle-paper: light-dark(#f4efe4, #14100e);
		--panicle-ink: light-dark(#241e19, #eaded0);
		--panicle-focus: light-dark(#7b1e3b, #df7d8c);
		display: inline-block;
		position: relative;
		overflow: hidden;
		width: 300px;
		height: 400px;
		contain: layout paint;
		color-scheme: light dark;
		background: var(--panicle-paper);
		color: var(--panicle-ink);
		font: 14px/1.4 system-ui, sans-serif;
	}
	:host([hidden]) { display: none; }
	:host([theme="light"]) { color-scheme: light; }
	:host([theme="dark"]) { color-scheme: dark; }
	canvas, img, .plant-handles {
		position: absolute;
		inset: 0 0 var(--panicle-bar, 0px);
		width: 100%;
		height: calc(100% - var(--panicle-bar, 0px));
	}
	canvas { touch-action: pan-y; cursor: grab; }
	:host(:is([capture], :fullscreen)) canvas { touch-action: none; }
	canvas:active { cursor: grabbing; }
	canvas:focus-visible { outline: 2px solid var(--panicle-focus); outline-offset: -2px; }
	img { object-fit: contain; pointer-events: none; }
	img:not([src]), [hidden] { display: none; }
	p {
		position: absolute;
		inset: auto 0 0;
		margin: 0;
		padding: 8px 12px;
		background: var(--panicle-paper);
		text-wrap: balance;
	}
	.unseen {
		inset: 0 auto auto 0;
		width: 1px;
		height: 1px;
		padding: 0;
		overflow: hidden;
		clip-path: inset(50%);
	}
`;
