/** Shapes of a stand's map: kinds differ in shape, not only in colour. Pure. */
import { firstOfSameName } from "../members";
import type { StandPlant } from "../stand_plant";

/** Size of the hole in a hollow shape, as a share of the shape. */
const HOLE = 0.55;

/** Draws a shape of about the area of a circle of that radius, as an SVG path. */
export type MapShape = (x: number, y: number, radius: number) => string;

/**
 * Returns a shape, and the same with a hole. The hole is the shape again, smaller and drawn the other way round, so
 * that the fill leaves it out.
 */
function withHollow(shape: (x: number, y: number, radius: number, reversed: boolean) => string): [MapShape, MapShape] {
	return [
		(x, y, radius) => shape(x, y, radius, false),
		(x, y, radius) => shape(x, y, radius, false) + shape(x, y, HOLE * radius, true),
	];
}

/**
 * Returns a polygon as a filled and a hollow shape.
 * @param corners from the centre, in shares of the radius
 */
function polygonShapes(corners: readonly (readonly [x: number, y: number])[]) {
	return withHollow((x, y, radius, reversed) => {
		const points = corners.map(([dx, dy]) => `${shortNumber(x + dx * radius)} ${shortNumber(y + dy * radius)}`);
		return `M${(reversed ? points.reverse() : points).join("L")}Z`;
	});
}

/** Writes a number with at most three decimals: millimetres of the ground. */
const shortNumber = (value: number): string => String(Math.round(value * 1000) / 1000);

const circle = withHollow((x, y, radius, reversed) => {
	const r = shortNumber(radius);
	const d = shortNumber(2 * radius);
	const sweep = reversed ? 1 : 0;
	return `M${shortNumber(x)} ${shortNumber(y)}m-${r} 0a${r} ${r} 0 1 ${sweep} ${d} 0a${r} ${r} 0 1 ${sweep} -${d} 0`;
});

/** Half a side of the square and of other shapes with the area of the unit circle. */
const HALF = 0.89;
const CROSS = 0.4;

const FILLED_AND_HOLLOW = [
	circle,
	polygonShapes([
		[0, -1.35],
		[1.2, 0.8],
		[-1.2, 0.8],
	]),
	polygonShapes([
		[-HALF, -HALF],
		[HALF, -HALF],
		[HALF, HALF],
		[-HALF, HALF],
	]),
	polygonShapes([
		[0, -1.3],
		[1.1, 0],
		[0, 1.3],
		[-1.1, 0],
	]),
	polygonShapes([
		[-CROSS, -1.2],
		[CROSS, -1.2],
		[CROSS, -CROSS],
		[1.2, -CROSS],
		[1.2, CROSS],
		[CROSS, CROSS],
		[CROSS, 1.2],
		[-CROSS, 1.2],
		[-CROSS, CROSS],
		[-1.2, CROSS],
		[-1.2, -CROSS],
		[-CROSS, -CROSS],
	]),
	polygonShapes([
		[0, 1.35],
		[1.2, -0.8],
		[-1.2, -0.8],
	]),
];

/** The shapes, in the order of the kinds: the filled ones, then the hollow ones; further kinds begin again. */
export const MAP_SHAPES: readonly MapShape[] = [0, 1].flatMap((hollow) =>
	FILLED_AND_HOLLOW.map((shapes) => shapes[hollow]),
);

/** Returns the shape of each kind; kinds of the same name share one. */
export function kindShapes(stand: Pick<StandPlant, "kinds">): readonly MapShape[] {
	const first = firstOfSameName(stand);
	const kinds = [...new Set(first)];
	return first.map((kind) => MAP_SHAPES[kinds.indexOf(kind) % MAP_SHAPES.length]);
}
