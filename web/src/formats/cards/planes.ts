/**
 * Groups of cards that one larger card can show: near each other, and nearly in one plane, as in billboard clouds
 * (Décoret et al. 2003, "Billboard clouds for extreme model simplification"). Leaves keep their area in every view,
 * because the plane is nearly theirs.
 */
import type { Vector } from "../../plant/part";
import { type Card, middleOf } from "./card";
import { add, cross, dot, perpendicular, scaled, subtract, unit } from "./vectors";

/** A rectangle in the plant's frame. */
export interface Plane {
	/** The numbers of its cards. */
	readonly members: readonly number[];
	/** The lower left corner. */
	readonly corner: Vector;
	/** Unit vectors. */
	readonly across: Vector;
	readonly along: Vector;
	readonly face: Vector;
	/** Metres. */
	readonly width: number;
	readonly height: number;
}

/** How much the directions of cards count beside their distances. */
const DIRECTION = 1.5;
/** Angles of the rectangle in its plane that are tried for the smallest area. */
const ANGLES = 12;
/** Rounds of the search for principal axes. */
const ROUNDS = 12;
/** Members of a group from which its mean and its axis are computed. */
const SAMPLED = 96;
/** Place and direction as numbers: x, y, z, and the tensor of the normal, which has no sign. */
const FEATURES = 9;

/**
 * Divides cards into groups, again and again, and returns the planes of the groups at each of several counts.
 * @param counts in falling order; planes of fewer groups contain those of more
 */
export function planesOf(cards: readonly Card[], counts: readonly number[]): Plane[][] {
	const features = featuresOf(cards);
	const groups = [
		group(
			cards.map((_, i) => i),
			features,
		),
	];
	const found = new Map<number, Plane[]>();
	for (const count of [...new Set(counts)].sort((a, b) => a - b)) {
		while (groups.length < count && divideWidest(groups, features)) {
			// Each step adds a group.
		}
		found.set(
			count,
			groups.map(({ members }) => planeOf(members, cards)),
		);
	}
	return counts.map((count) => found.get(count) as Plane[]);
}

/** Divides the group with the largest spread at its mean; returns false where no group can be divided. */
function divideWidest(groups: Group[], features: Float64Array): boolean {
	const widest = groups.reduce((best, each, i) => (each.spread > groups[best].spread ? i : best), 0);
	const { members, axis, mean, spread } = groups[widest];
	if (spread <= 0) return false;
	const [one, other]: [number[], number[]] = [[], []];
	for (const member of members) {
		let sum = 0;
		for (let k = 0; k < FEATURES; k++) sum += axis[k] * (features[FEATURES * member + k] - mean[k]);
		(sum > 0 ? one : other).push(member);
	}
	if (one.length === 0 || other.length === 0) {
		groups[widest] = { ...groups[widest], spread: 0 };
		return true;
	}
	groups[widest] = group(one, features);
	groups.push(group(other, features));
	return true;
}

interface Group {
	readonly members: readonly number[];
	/** The spread along its principal axis, weighted by the number of cards. */
	readonly spread: number;
	readonly axis: Float64Array;
	readonly mean: Float64Array;
}

/** Returns the features of all cards, FEATURES each. */
function featuresOf(cards: readonly Card[]): Float64Array {
	const features = new Float64Array(FEATURES * cards.length);
	const weight = DIRECTION * typicalDistance(cards);
	for (const [i, card] of cards.entries()) {
		const [x, y, z] = card.face;
		const tensor = [x * x, y * y, z * z, Math.SQRT2 * x * y, Math.SQRT2 * y * z, Math.SQRT2 * z * x];
		features.set([...middleOf(card), ...tensor.map((value) => weight * value)], FEATURES * i);
	}
	return features;
}

/** Returns a length that scales with the crown: a quarter of its radius. */
function typicalDistance(cards: readonly Card[]): number {
	const middles = cards.map(middleOf);
	const mean = scaled(
		middles.reduce((sum, middle) => add(sum, middle), [0, 0, 0]),
		1 / Math.max(1, middles.length),
	);
	const squares = middles.reduce((sum, middle) => sum + dot(subtract(middle, mean), subtract(middle, mean)), 0);
	return 0.25 * Math.sqrt(squares / Math.max(1, middles.length));
}

/** Makes a group: its mean, its principal axis by power iteration, and its spread along it, from some of its members. */
function group(members: readonly number[], features: Float64Array): Group {
	const step = Math.max(1, Math.floor(members.length / SAMPLED));
	const mean = new Float64Array(FEATURES);
	let count = 0;
	for (let i = 0; i < members.length; i += step, count++)
		for (let k = 0; k < FEATURES; k++) mean[k] += features[FEATURES * members[i] + k];
	for (let k = 0; k < FEATURES; k++) mean[k] /= count;
	const matrix = new Float64Array(FEATURES * FEATURES);
	for (let at = 0; at < members.length; at += step)
		for (let i = 0; i < FEATURES; i++) {
			const value = features[FEATURES * members[at] + i] - mean[i];
			for (let j = 0; j < FEATURES; j++)
				matrix[FEATURES * i + j] += value * (features[FEATURES * members[at] + j] - mean[j]);
		}
	const axis = Float64Array.from({ length: FEATURES }, (_, i) => 1 + 0.1 * i);
	const next = new Float64Array(FEATURES);
	let spread = 0;
	for (let round = 0; round < ROUNDS; round++) {
		let squares = 0;
		for (let i = 0; i < FEATURES; i++) {
			next[i] = 0;
			for (let j = 0; j < FEATURES; j++) next[i] += matrix[FEATURES * i + j] * axis[j];
			squares += next[i] * next[i];
		}
		spread = Math.sqrt(squares);
		if (spread < 1e-15) break;
		for (let i = 0; i < FEATURES; i++) axis[i] = next[i] / spread;
	}
	return { members, spread: members.length > 1 ? (spread * members.length) / count : 0, axis, mean };
}

/** Returns the direction that cards face most: the principal axis of their normals' tensor, by power iteration. */
function directionOf(members: readonly number[], cards: readonly Card[]): Vector {
	let axis = cards[members[0]].face;
	for (let round = 0; round < ROUNDS; round++) {
		let next: Vector = [0, 0, 0];
		for (const member of members) next = add(next, scaled(cards[member].face, dot(cards[member].face, axis)));
		axis = unit(next, axis);
	}
	return axis;
}

/** Returns the smallest rectangle in a plane that holds some cards. */
function planeOf(members: readonly number[], cards: readonly Card[]): Plane {
	const face = directionOf(members, cards);
	const middle = scaled(
		members.reduce<Vector>((sum, member) => add(sum, middleOf(cards[member])), [0, 0, 0]),
		1 / members.length,
	);
	const points = members.flatMap((member) => cards[member].corners.map((corner) => subtract(corner, middle)));
	const [right, up] = [perpendicular(face), cross(face, perpendicular(face))];
	let best: Omit<Plane, "members"> | undefined;
	for (let i = 0; i < ANGLES; i++) {
		const angle = (0.5 * Math.PI * i) / ANGLES;
		const across = add(scaled(right, Math.cos(angle)), scaled(up, Math.sin(angle)));
		const along = cross(face, across);
		let [left, bottom] = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
		let [rightmost, top] = [Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY];
		for (const point of points) {
			const [x, y] = [dot(point, across), dot(point, along)];
			[left, rightmost] = [Math.min(left, x), Math.max(rightmost, x)];
			[bottom, top] = [Math.min(bottom, y), Math.max(top, y)];
		}
		const [width, height] = [rightmost - left, top - bottom];
		if (best && best.width * best.height <= width * height) continue;
		const corner = add(middle, add(scaled(across, left), scaled(along, bottom)));
		best = { corner, across, along, face, width, height };
	}
	return { members, ...(best as Omit<Plane, "members">) };
}
