import { css } from "lit";

/** Styles of the profile's views, added to handle_style.ts. */
export const profileStyle = css`
	:host {
		aspect-ratio: 1;
		isolation: isolate;
	}
	svg.drawing {
		overflow: visible;
	}
	path,
	line,
	circle {
		vector-effect: non-scaling-stroke;
	}
	canvas {
		opacity: 0.34;
	}
	.envelope {
		fill: color-mix(in srgb, var(--grip) 5%, transparent);
		stroke: color-mix(in srgb, var(--grip) 45%, transparent);
		stroke-width: 1px;
		stroke-dasharray: 1 3;
		stroke-linecap: round;
	}
	.own {
		fill: none;
		stroke: color-mix(in srgb, var(--grip) 80%, transparent);
		stroke-width: 1px;
		stroke-dasharray: 4 3;
	}
	.outline {
		fill: none;
		stroke: currentColor;
		stroke-width: 1.1px;
		stroke-linejoin: round;
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
		stroke: var(--ground);
		stroke-width: 3px;
		stroke-linejoin: round;
		paint-order: stroke;
		pointer-events: none;
	}
	.name {
		opacity: 0.75;
	}
	.symbol {
		font: italic 400 1.25em / 0 var(--serif, Georgia, "Times New Roman", serif);
	}
	.subscript {
		font-size: 12px;
	}
	.value {
		fill: var(--grip);
	}
	.handle .name {
		line-height: 1.2;
		position: absolute;
		top: 1px;
		left: 50%;
		translate: calc(-50% + var(--shift));
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
		font-size: 12px;
		line-height: 0;
	}
	.handle:is(:hover, :focus-visible, .held) .name {
		opacity: 1;
	}
	@media (forced-colors: active) {
		.guide {
			stroke: Highlight;
		}
	}
`;
