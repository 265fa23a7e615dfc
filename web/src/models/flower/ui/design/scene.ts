/** What a flat view of a designed flower shows: lines in units of its own, y downwards, and handles that describe an organ otherwise. */
import type { Point } from "../../../../ui/handles/point";
import type { Description } from "../../design/description";

export interface SceneLine {
	/** A path. */
	readonly d: string;
	/** Of an organ, a guide, a middle line, or the stem and the bract that a flower stands between. */
	readonly kind: "organ" | "faint" | "axis" | "around";
	/** Six hexadecimal digits: what it is filled with; absent: nothing. */
	readonly fill?: string;
	/** Whether it is of the organ that is chosen. */
	readonly chosen?: boolean;
}

export interface SceneHandle {
	readonly id: string;
	/** "Petals, how many". */
	readonly label: string;
	/** "5". */
	readonly value: string;
	readonly at: Point;
	/** The organ as it is with the handle taken there. */
	pull(to: Point): Description;
	/** The same by a key: steps to the right and up, large ones with Shift. */
	nudge(right: number, up: number, large: boolean): Description;
}

export interface Scene {
	/** What has to be in view. */
	readonly box: { readonly left: number; readonly top: number; readonly right: number; readonly bottom: number };
	readonly lines: readonly SceneLine[];
	readonly handles: readonly SceneHandle[];
}

/** A scene as a picture by itself, for the docs: ink on paper. */
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

/** To the hundredth. */
export const short = (value: number): number => Math.round(value * 100) / 100 + 0;

/** A path through points. */
export const pathOf = (points: readonly Point[], closed = false): string =>
	`M${points.map(({ x, y }) => `${short(x)} ${short(y)}`).join("L")}${closed ? "Z" : ""}`;

/** A path round a point. */
export const roundPath = ({ x, y }: Point, r: number): string =>
	`M${short(x - r)} ${short(y)}a${short(r)} ${short(r)} 0 1 0 ${short(2 * r)} 0a${short(r)} ${short(r)} 0 1 0 ${short(-2 * r)} 0Z`;
