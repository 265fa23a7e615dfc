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
const LARGE_STEPS = 10;

/**
 * Returns the placement of a picture as high as the bunch, in the middle of the view.
 * @param length of the bunch, pixels of the profile
 */
export function fitted({ width, height }: Pick<ImageBitmap, "width" | "height">, length: number): Placement {
	const scale = length / height;
	return { x: (-width * scale) / 2, y: 0, scale };
}

/** Moves a placement by a distance in pixels of the profile. */
export function shifted({ x, y, scale }: Placement, by: Point): Placement {
	return { x: x + by.x, y: y + by.y, scale };
}

/** Returns the placement of a picture scaled about a point of the view, which stays in place; limits its size. */
export function zoomed<P extends Placement & Pick<Photo, "picture">>(
	photo: P,
	factor: number,
	fixedPoint: Point,
): Placement {
	const { x, y, scale, picture } = photo;
	const longer = Math.max(picture.width, picture.height);
	const newScale = Math.min(Math.max(scale * factor, SMALLEST / longer), LARGEST / longer);
	const appliedFactor = newScale / scale;
	return {
		x: fixedPoint.x + appliedFactor * (x - fixedPoint.x),
		y: fixedPoint.y + appliedFactor * (y - fixedPoint.y),
		scale: newScale,
	};
}

/** Returns the centre of a placed picture. */
export function middleOf({ x, y, scale, picture }: Placement & Pick<Photo, "picture">): Point {
	return { x: x + (scale * picture.width) / 2, y: y + (scale * picture.height) / 2 };
}

/**
 * Returns the placement after two fingers moved from one pair of points to another; the points under them stay under
 * them, except for rotation.
 */
export function pinched(photo: Photo, from: readonly [Point, Point], to: readonly [Point, Point]): Placement {
	const distance = ([a, b]: readonly [Point, Point]) => Math.hypot(a.x - b.x, a.y - b.y);
	const middle = ([a, b]: readonly [Point, Point]) => ({ x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 });
	const [before, after] = [middle(from), middle(to)];
	const factor = distance(from) > 0 ? distance(to) / distance(from) : 1;
	const scaled = { ...photo, ...zoomed(photo, factor, before) };
	return shifted(scaled, { x: after.x - before.x, y: after.y - before.y });
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
	const steps = shiftKey ? LARGE_STEPS : 1;
	const arrow = ARROWS[key];
	if (arrow) return shifted(photo, { x: steps * arrow.x, y: steps * arrow.y });
	const grows = key === "+" || key === "=" || key === "*";
	if (!grows && key !== "-" && key !== "_") return undefined;
	return zoomed(photo, grows ? FACTOR ** steps : FACTOR ** -steps, middleOf(photo));
}
