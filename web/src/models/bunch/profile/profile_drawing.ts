/** Templates of a view's drawing: state in, templates out. Coordinates in the SVG are pixels of the profile. */
import { html, nothing, svg, type TemplateResult } from "lit";
import type { Point } from "../../../ui/handles/point";
import { drawScaleBar } from "../../../ui/handles/scale_bar";
import type { OwnProfile } from "../bunch_plant";
import type { BunchSpecimen as Specimen } from "../specimen";
import { envelopePath } from "./envelope";
import {
	type BunchShape,
	type Handle,
	handlePosition,
	inMillimetres,
	isSide,
	type ScaledShape,
	type ShapeKey,
	SIDES,
	VIEW_SIDES,
	type View,
} from "./handles";
import { scaleBar, type ViewFrame } from "./view_frame";

/** Returns the SVG transform of content at a point of the profile that keeps its size on the screen. */
function pin(frame: ViewFrame, x: number, y: number): string {
	return `translate(${x} ${y}) scale(${1 / frame.scale})`;
}

/** Draws the envelope, the octahedron's outline and axis, and p1. */
export function drawOutline(parameters: Specimen["parameters"], view: View, frame: ViewFrame): TemplateResult {
	const [right, left] = VIEW_SIDES[view].map((handle) => handlePosition(parameters, handle));
	const { l } = parameters;
	return svg`
		<path class="envelope" d=${envelopePath(parameters, view)}></path>
		<line class="axis" x1="0" y1="0" x2="0" y2=${l}></line>
		<path class="outline" d="M0 0L${right.x} ${right.y}L0 ${l}L${left.x} ${left.y}Z"></path>
		<g transform=${pin(frame, 0, 0)}>
			<circle class="root" r="2.5"></circle>
			<text class="name" y="-6" text-anchor="middle"><tspan class="symbol">p</tspan><tspan class="subscript" dy="2">1</tspan></text>
		</g>`;
}

/** Draws the outline that the seed's bunch fills, if it differs from the handles'. */
export function drawOwn(parameters: Specimen["parameters"], own: OwnProfile | undefined, view: View): unknown {
	if (!own || !differs(parameters, own)) return nothing;
	return svg`<path class="own" d=${envelopePath({ ...parameters, ...own }, view)}></path>`;
}

/** Returns whether two profiles differ by more than half a pixel. */
function differs(parameters: BunchShape, own: OwnProfile): boolean {
	return Object.entries(own).some(([key, value]) => Math.abs(parameters[key as keyof OwnProfile] - value) > 0.5);
}

/** Returns a handle's position in CSS pixels from the view's corner. */
export function handlePlace(shape: BunchShape, handle: Handle, frame: ViewFrame): Point {
	const { x, y } = handlePosition(shape, handle);
	return { x: (x - frame.left) * frame.scale, y: (y - frame.top) * frame.scale };
}

/** Draws a handle's name beside its dot, shifted outwards near the axis to avoid p1's and its opposite's names. */
export function drawName(shape: BunchShape, handle: Handle, frame: ViewFrame): TemplateResult {
	const { x } = handlePosition(shape, handle);
	const shift = isSide(handle) ? SIDES[handle].sign * Math.max(5, 19 - Math.abs(x) * frame.scale) : 0;
	return html`<span class="name" .style=${`--shift: ${shift}px`}
		><span class="symbol">p</span><sub>${handle.slice(1)}</sub></span>`;
}

/**
 * Draws a handle's numbers on lines from the axis and from the level of p1, with the paper's pixels if `pixels` is
 * set.
 */
export function drawGuides(shape: ScaledShape, handle: Handle, frame: ViewFrame, pixels: boolean): TemplateResult {
	const { x, y } = handlePosition(shape, handle);
	const text = (key: ShapeKey) => `${inMillimetres(shape, key)} mm${pixels ? ` · ${shape[key]} px` : ""}`;
	if (!isSide(handle)) {
		const words = drawValue("l", "", text("l"), -6, 4, "end");
		return svg`<line class="guide" x1="0" y1="0" x2="0" y2=${y}></line>
			<g transform=${pin(frame, 0, y * 0.62)}>${words}</g>`;
	}
	const { sign } = SIDES[handle];
	const index = handle.slice(1);
	const w = drawValue("w", index, text(`${handle}w`), 0, 13, "middle");
	const r = drawValue("r", index, text(`${handle}r`), -6 * sign, 4, sign > 0 ? "end" : "start");
	return svg`<line class="guide" x1="0" y1=${y} x2=${x} y2=${y}></line>
		<line class="guide" x1="0" y1="0" x2=${x} y2="0"></line>
		<line class="guide" x1=${x} y1="0" x2=${x} y2=${y}></line>
		<g transform=${pin(frame, x / 2, y)}>${w}</g>
		<g transform=${pin(frame, x, y / 2)}>${r}</g>`;
}

/**
 * Draws a value with its symbol and subscript, such as "l" or "w₃".
 * @param index subscript of the symbol
 * @param anchor text-anchor of the SVG text
 */
function drawValue(symbol: string, index: string, value: string, x: number, y: number, anchor: string): TemplateResult {
	return svg`<text class="value" x=${x} y=${y} text-anchor=${anchor}><tspan class="symbol">${symbol}</tspan><tspan class="subscript" dy="2"
		>${index}</tspan><tspan dy=${index ? -2 : 0}> ${value}</tspan></text>`;
}

/**
 * Draws a scale bar at the lower left.
 * @param extent side of the visible square, pixels of the profile
 * @param unit millimetres per unit of the paper
 */
export function drawScale(extent: number, unit: number, frame: ViewFrame): TemplateResult {
	const { length, label } = scaleBar(extent, unit);
	const pixels = length * frame.scale;
	const corner = pin(frame, frame.left + 8 / frame.scale, frame.top + frame.height - 8 / frame.scale);
	return drawScaleBar(pixels, label, corner);
}
