import { css } from "lit";

/** Styles of the flat views in addition to handle_style.ts. */
export const gripStyle = css`
	canvas {
		opacity: 0.5;
	}
	.outer {
		fill: color-mix(in srgb, var(--grip) 5%, transparent);
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
		stroke: var(--grip);
		stroke-width: 1px;
		stroke-dasharray: 3 2;
	}
	text {
		opacity: 0.75;
	}
`;
