/**
 * Scene of a flat view: lines in the view's own units, y downwards, and handles that change an organ's description.
 */
import type { Point } from "../../../../ui/handles/point";
import type { Description } from "../../design/description";

export interface SceneLine {
	/** Path data of SVG. */
	readonly d: string;
	/** Content of the line: an organ, a guide, a middle line, or the axis and bract around the flower. */
	readonly kind: "organ" | "faint" | "axis" | "around";
	/** Fill colour, six hexadecimal digits; absent for none. */
	readonly fill?: string;
	/** Whether the line belongs to the selected organ. */
	readonly chosen?: boolean;
}

export interface SceneHandle {
	readonly id: string;
	/** Label, as "Petals, how many". */
	readonly label: string;
	/** Value in words, as "5". */
	readonly value: string;
	readonly at: Point;
	/** Returns the organ's description with the handle moved to a point. */
	pull(to: Point): Description;
	/** Returns the organ's description after steps to the right and up; large ones with Shift. */
	nudge(right: number, up: number, large: boolean): Description;
}

export interface Scene {
	/** Bounds that must be visible. */
	readonly box: { readonly left: number; readonly top: number; readonly right: number; readonly bottom: number };
	readonly lines: readonly SceneLine[];
	readonly handles: readonly SceneHandle[];
}

/** Returns a scene as an SVG document, dark lines on white. */
export function pictureOf({ box, lines }: Scene, title: string): string {
	const [width, height] = [box.right - box.left, box.bottom - box.top];
	const unit = Math.max(width, height) / 100;
	const drawn = lines.map(({ d, kind, fill }) => {
		const look =
			kind === "organ" ? `stroke="#2a2622" fill="${fill ? `#${fill}` : "none"}"` : 'stroke="#9a938a" fill="none"';
		return `<path d="${d}" ${look} stroke-width="${short(0.5 * unit)}" stroke-linejoin="round"/>`;
	});
	const frame = [box.left, box.top, width, height].map(short).join(" ");
	return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="${frame}" width="320" height="${Math.round((320 * height) / width)}">\n<title>${title}</title>\n${drawn.join("\n")}\n</svg>\n`;
}

/** Rounds to hundredths. */
export const short = (value: number): number => Math.round(value * 100) / 100 + 0;

/** Returns the path through points, for SVG. */
export const pathOf = (points: readonly Point[], closed = false): string =>
	`M${points.map(({ x, y }) => `${short(x)} ${short(y)}`).join("L")}${closed ? "Z" : ""}`;

/** Returns the path of a circle with radius `r`, for SVG. */
export const roundPath = ({ x, y }: Point, r: number): string =>
	`M${short(x - r)} ${short(y)}a${short(r)} ${short(r)} 0 1 0 ${short(2 * r)} 0a${short(r)} ${short(r)} 0 1 0 ${short(-2 * r)} 0Z`;
