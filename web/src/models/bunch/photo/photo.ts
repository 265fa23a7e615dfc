/** A photograph behind a flat view, and its placement by pointer and keys. All lengths are pixels of the profile. */
import type { Point } from "../../../ui/handles/point";
import type { View } from "../profile/handles";

/** Placement of a picture: its upper left corner relative to p1, and the size of one of its own pixels. */
export interface Placement {
	readonly x: number;
	readonly y: number;
	readonly scale: number;
}

export interface Photo extends Placement {
	readonly picture: ImageBitmap;
	/** View that it is behind. */
	readonly view: View;
	/** Opacity, 0 … 1. */
	readonly opacity: number;
	/** Whether the pointer moves the photograph as well as the handles. */
	readonly loose: boolean;
}

/** Smallest and largest longer side; beyond these the picture would be hard to find again. */
const SMALLEST = 20;
const LARGEST = 6000;
/** Shift in pixels, and scale factor, of one key press. */
const STEP = 1;
const FACTOR = 1.01;
/** Multiple of a step with Shift. */
const FAR = 10;

/** Places a picture as high as the bunch, in the middle of the view. */
export function fitted({ width, height }: Pick<ImageBitmap, "width" | "height">, length: number): Placement {
	const scale = length / height;
	return { x: (-width * scale) / 2, y: 0, scale };
}

export function shifted({ x, y, scale }: Placement, by: Point): Placement {
	return { x: x + by.x, y: y + by.y, scale };
}

/** Scales a picture about a point of the view. */
export function zoomed<P extends Placement & Pick<Photo, "picture">>(
	photo: P,
	factor: number,
	about: Point,
): Placement {
	const { x, y, scale, picture } = photo;
	const longer = Math.max(picture.width, picture.height);
	const after = Math.min(Math.max(scale * factor, SMALLEST / longer), LARGEST / longer);
	const by = after / scale;
	return { x: about.x + by * (x - about.x), y: about.y + by * (y - about.y), scale: after };
}

/** Returns the centre of a placed picture. */
export function middleOf({ x, y, scale, picture }: Placement & Pick<Photo, "picture">): Point {
	return { x: x + (scale * picture.width) / 2, y: y + (scale * picture.height) / 2 };
}

/** Moves and scales a picture with two fingers; the points under them stay under them, except for rotation. */
export function pinched(photo: Photo, from: readonly [Point, Point], to: readonly [Point, Point]): Placement {
	const apart = ([a, b]: readonly [Point, Point]) => Math.hypot(a.x - b.x, a.y - b.y);
	const between = ([a, b]: readonly [Point, Point]) => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });
	const [before, after] = [between(from), between(to)];
	const factor = apart(from) > 0 ? apart(to) / apart(from) : 1;
	const larger = { ...photo, ...zoomed(photo, factor, before) };
	return shifted(larger, { x: after.x - before.x, y: after.y - before.y });
}

const ARROWS: Readonly<Record<string, Point>> = {
	ArrowLeft: { x: -STEP, y: 0 },
	ArrowRight: { x: STEP, y: 0 },
	ArrowUp: { x: 0, y: -STEP },
	ArrowDown: { x: 0, y: STEP },
};

/** Returns the placement after a key press; undefined for other keys. */
export function nudged(
	photo: Photo,
	{ key, shiftKey }: Pick<KeyboardEvent, "key" | "shiftKey">,
): Placement | undefined {
	const far = shiftKey ? FAR : 1;
	const arrow = ARROWS[key];
	if (arrow) return shifted(photo, { x: far * arrow.x, y: far * arrow.y });
	const grows = key === "+" || key === "=" || key === "*";
	if (!grows && key !== "-" && key !== "_") return undefined;
	return zoomed(photo, grows ? FACTOR ** far : FACTOR ** -far, middleOf(photo));
}
