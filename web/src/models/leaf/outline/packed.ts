/**
 * Outlines in links: each point takes four characters of base 64 (RFC 4648, section 5), most significant first: kind
 * in 2 bits, then x + 1.024 and y + 0.5 in thousandths, 11 bits each. After `~` only the right side follows; the left
 * side is its mirror image.
 */
import { bothSides, isSymmetric, KINDS, type OutlinePoint, type OutlinePoints, REACH, rightSide, STEP } from "./points";

const DIGITS = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
const CHARACTERS = 4;
const BITS = 11;
const MASK = (1 << BITS) - 1;
const HALF = "~";
/** The least x minus one, and the least y, in steps. */
const LEAST = { x: Math.round(REACH.x[0] / STEP) - 1, y: Math.round(REACH.y[0] / STEP) };
const STEPS = Math.round(1 / STEP);

/** Encodes an outline for a link: a symmetric one as `~` and its right side, another one with all points. */
export function packOutline(points: OutlinePoints): string {
	const half = rightSide(points);
	// Two points on the midrib opposite each other would be decoded as one.
	const isHalf = isSymmetric(points) && bothSides(half).length === points.length;
	return isHalf ? HALF + half.map(packPoint).join("") : points.map(packPoint).join("");
}

/** Decodes an outline; undefined where the text is invalid. */
export function unpackOutline(text: string): OutlinePoint[] | undefined {
	const digits = text.startsWith(HALF) ? text.slice(HALF.length) : text;
	if (digits.length % CHARACTERS !== 0 || !/^[\w-]*$/.test(digits)) return undefined;
	const points = Array.from({ length: digits.length / CHARACTERS }, (_, index) =>
		unpackPoint(digits.slice(CHARACTERS * index, CHARACTERS * (index + 1))),
	);
	return digits === text ? points : bothSides(points);
}

/** Encodes a point as four characters: kind, x and y are joined to 24 bits, and each 6 bits give a character. */
function packPoint({ x, y, kind }: OutlinePoint): string {
	const across = Math.round(x / STEP) - LEAST.x;
	const up = Math.round(y / STEP) - LEAST.y;
	const word = (((KINDS.indexOf(kind) << BITS) | across) << BITS) | up;
	return [18, 12, 6, 0].map((shift) => DIGITS[(word >> shift) & 63]).join("");
}

/** Decodes the four characters of a point: they give 24 bits, which hold kind, x and y. */
function unpackPoint(characters: string): OutlinePoint {
	const word = [...characters].reduce((sum, digit) => (sum << 6) | DIGITS.indexOf(digit), 0);
	const step = (shift: number, least: number) => (((word >> shift) & MASK) + least) / STEPS + 0; // −0 becomes 0
	return { x: step(BITS, LEAST.x), y: step(0, LEAST.y), kind: KINDS[word >> (2 * BITS)] };
}
