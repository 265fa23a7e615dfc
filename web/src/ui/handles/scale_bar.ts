import { svg, type TemplateResult } from "lit";

/** Returns the longest round length (1, 2 or 5 times a power of ten) that is not above `most`. */
export function roundLength(most: number): number {
	const decade = 10 ** Math.floor(Math.log10(most));
	return decade * (most >= 5 * decade ? 5 : most >= 2 * decade ? 2 : 1);
}

/** Draws a scale bar; `transform` moves its left end in an SVG. */
export function drawScaleBar(pixels: number, label: string, transform: string): TemplateResult {
	return svg`<g class="scale" transform=${transform}>
		<line x1="0" y1="0" x2=${pixels} y2="0"></line>
		<line x1="0" y1="-3" x2="0" y2="0"></line>
		<line x1=${pixels} y1="-3" x2=${pixels} y2="0"></line>
		<text x=${pixels / 2} y="-6" text-anchor="middle">${label}</text>
	</g>`;
}
