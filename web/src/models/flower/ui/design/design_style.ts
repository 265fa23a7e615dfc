import { css } from "lit";

/** Styles of a design's views, added to handle_style.ts. */
export const designStyle = css`
	.drawing path {
		vector-effect: non-scaling-stroke;
		stroke: currentColor;
		stroke-width: 1.1px;
		stroke-linejoin: round;
	}
	.drawing .organ {
		fill-opacity: 0.55;
	}
	.drawing .chosen {
		stroke-width: 1.9px;
		fill-opacity: 0.85;
	}
	.drawing .faint,
	.drawing .around,
	.drawing .axis {
		stroke-opacity: 0.4;
		stroke-width: 0.9px;
	}
	.drawing .faint {
		stroke-dasharray: 3 3;
	}
	.handle::before {
		width: 11px;
		height: 11px;
	}
	.handle::after {
		width: 20px;
		height: 20px;
	}
`;
