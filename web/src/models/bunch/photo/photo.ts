/** A photograph behind a flat view, and what hands and keys do to where it lies. All lengths are pixels of the profile. */
import type { Point } from "../../../ui/handles/point";
import type { View } from "../profile/handles";

/** Where a picture lies: its upper left corner from p1, and how large one of its own pixels is. */
export interface Placement {
	readonly x: number;
	readonly y: number;
	readonly scale: number;
}

export interface Photo extends Placement {
	readonly picture: ImageBitmap;
	/** The view that it lies behind. */
	readonly view: View;
	/** From 0 to 1. */
	readonly opacity: number;
	/** Whether hands move it, and not the handles alone. */
	readonly loose: boolean;
}

/** Of the profile's length; smaller or larger nobody finds it again. */
const SMALLEST = 20;
const LARGEST = 6000;
/** What one press of a key does, in pixels and as a factor. */
const STEP = 1;
const FACTOR = 1.01;
/** How much further keys go with Shift. */
const FAR = 10;

/** As high as the bunch, in the middle of the view. */
export function fitted({ width, height }: Pick<ImageBitmap, "width" | "height">, length: number): Placement {
	const scale = length / height;
	return { x: (-width * scale) / 2, y: 0, scale };
}

export function shifted({ x, y, scale }: Placement, by: Point): Placement {
	return { x: x + by.x, y: y + by.y, scale };
}

/** Larger by a factor, a place of the view staying where it is. */
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

/** The middle of a picture as it lies. */
export function middleOf({ x, y, scale, picture }: Placement & Pick<Photo, "picture">): Point {
	return { x: x + (scale * picture.width) / 2, y: y + (scale * picture.height) / 2 };
}

/** Where two fingers take it: what was under each stays under it, but for a turn. */
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

/** What a key does to it; undefined for nothing. */
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
