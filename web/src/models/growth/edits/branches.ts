/** The branches of a grown tree, for choosing one in the 3-D view. Pure functions, in the plant's metres. */
import type { PointerRay } from "../../../ui/handles/handle_ways";
import type { GrowthPlant } from "../growth_plant";
import type { EditPoint } from "./branch_edit";

/** A shoot of the tree: a trunk or a branch. */
export interface Branch {
	/** By which edits name it: 16 hexadecimal digits. */
	readonly address: string;
	/** 0 for a trunk. */
	readonly order: number;
	/** The branch or trunk on which it grows; undefined for a trunk. */
	readonly parent: string | undefined;
	/** From its base to its tip: the ends of its segments. */
	readonly line: readonly EditPoint[];
	/** Addresses of the branches on it, from its base to its tip. */
	readonly children: readonly string[];
}

export interface Branches {
	/** In the order of their shoots. */
	readonly byAddress: ReadonlyMap<string, Branch>;
	/** Addresses of the trunks. */
	readonly trunks: readonly string[];
}

/** A place on a branch. */
export interface BranchPlace {
	readonly address: string;
	/** Share 0 … 1 of the length of its line. */
	readonly at: number;
}

const found = new WeakMap<GrowthPlant, Branches>();

/** Returns the branches of a plant; computed once for each plant. */
export function branchesOf(plant: GrowthPlant): Branches {
	const before = found.get(plant);
	if (before) return before;
	const { segments, shoots, addresses } = plant;
	const branches = new Map<string, Branch & { line: EditPoint[]; children: string[] }>();
	// Addresses of shoots as text: many segments are of one shoot.
	const names = new Map<number, string>();
	const addressOf = (segment: number): string => {
		const shoot = shoots.shoot[segment];
		const name = names.get(shoot) ?? addressOfShoot(addresses, shoot);
		names.set(shoot, name);
		return name;
	};
	const pointOf = (segment: number, end: 0 | 3): EditPoint => {
		const at = 6 * segment + end;
		return [segments.ends[at], segments.ends[at + 1], segments.ends[at + 2]];
	};
	const trunks: string[] = [];
	for (let i = 0; i < segments.count; i++) {
		const address = addressOf(i);
		let branch = branches.get(address);
		if (!branch) {
			const parent = segments.parent[i] < 0 ? undefined : addressOf(segments.parent[i]);
			branch = { address, order: shoots.order[i], parent, line: [pointOf(i, 0)], children: [] };
			branches.set(address, branch);
			if (parent === undefined) trunks.push(address);
			else branches.get(parent)?.children.push(address);
		}
		branch.line.push(pointOf(i, 3));
	}
	for (const { line, children } of branches.values()) {
		const along = new Map(children.map((child) => [child, nearestOn(line, branches.get(child)?.line[0] ?? line[0])]));
		children.sort((a, b) => (along.get(a) ?? 0) - (along.get(b) ?? 0));
	}
	const result = { byAddress: branches, trunks };
	found.set(plant, result);
	return result;
}

/** Returns the address of a shoot as edits write it. */
function addressOfShoot(addresses: Uint32Array, shoot: number): string {
	return [addresses[2 * shoot + 1], addresses[2 * shoot]].map((half) => half.toString(16).padStart(8, "0")).join("");
}

/** Returns the index of the point of a line that is nearest to a place. */
function nearestOn(line: readonly EditPoint[], place: EditPoint): number {
	const distances = line.map((point) => distance(point, place));
	return distances.indexOf(Math.min(...distances));
}

/**
 * Returns the place on a branch that a ray meets, or passes within a small angle; undefined if there is none. Wood that
 * the ray meets comes first, the nearest to the eye; then the wood that it passes most closely.
 * @param slack tangent of the angle
 */
export function placeUnderRay(
	plant: GrowthPlant,
	{ origin, direction }: PointerRay,
	slack: number,
): BranchPlace | undefined {
	const { segments, shoots } = plant;
	const { ends, radii } = segments;
	const length = Math.hypot(...direction);
	const [sx, sy, sz] = direction.map((value) => value / length);
	let best: { segment: number; share: number; score: number } | undefined;
	for (let i = 0, at = 0; i < segments.count; i++, at += 6) {
		const [bx, by, bz] = [ends[at] - origin[0], ends[at + 1] - origin[1], ends[at + 2] - origin[2]];
		const [wx, wy, wz] = [ends[at + 3] - ends[at], ends[at + 4] - ends[at + 1], ends[at + 5] - ends[at + 2]];
		// The nearest point of the segment to the ray minimises the distance across the direction of sight.
		const [baseDepth, wayDepth] = [bx * sx + by * sy + bz * sz, wx * sx + wy * sy + wz * sz];
		const [ax, ay, az] = [bx - baseDepth * sx, by - baseDepth * sy, bz - baseDepth * sz];
		const [cx, cy, cz] = [wx - wayDepth * sx, wy - wayDepth * sy, wz - wayDepth * sz];
		const square = cx * cx + cy * cy + cz * cz;
		const share = square > 0 ? Math.min(1, Math.max(0, -(ax * cx + ay * cy + az * cz) / square)) : 0;
		const depth = baseDepth + share * wayDepth;
		if (depth <= 0) continue;
		const off = Math.hypot(ax + share * cx, ay + share * cy, az + share * cz);
		const radius = radii[2 * i] + share * (radii[2 * i + 1] - radii[2 * i]);
		const angle = Math.max(0, off - radius) / depth;
		if (angle > slack) continue;
		// Wood under the ray has scores below those of wood beside it.
		const score = angle === 0 ? depth : 1e6 * (1 + angle);
		if (!best || score < best.score) best = { segment: i, share, score };
	}
	if (!best) return undefined;
	return placeOn(plant, best.segment, best.share, shoots.shoot[best.segment]);
}

/** Returns the place at a share of a segment, as a share of its whole shoot. */
function placeOn(plant: GrowthPlant, segment: number, share: number, shoot: number): BranchPlace {
	const { segments, shoots, addresses } = plant;
	let [before, whole] = [0, 0];
	for (let i = 0; i < segments.count; i++) {
		if (shoots.shoot[i] !== shoot) continue;
		const at = 6 * i;
		const length = Math.hypot(...[0, 1, 2].map((k) => segments.ends[at + 3 + k] - segments.ends[at + k]));
		whole += length;
		if (i < segment) before += length;
		else if (i === segment) before += share * length;
	}
	return { address: addressOfShoot(addresses, shoot), at: whole > 0 ? before / whole : 0 };
}

/** Returns a branch's neighbour in a direction: its parent, its first branch, or the next or previous beside it. */
export function neighbourOf(
	{ byAddress, trunks }: Branches,
	address: string | undefined,
	direction: "parent" | "child" | "next" | "previous",
): string | undefined {
	const branch = address === undefined ? undefined : byAddress.get(address);
	if (!branch) return trunks[0];
	if (direction === "parent") return branch.parent ?? branch.address;
	if (direction === "child") return branch.children[0] ?? branch.address;
	const beside = siblingsOf({ byAddress, trunks }, branch);
	const step = direction === "next" ? 1 : beside.length - 1;
	return beside[(beside.indexOf(branch.address) + step) % beside.length];
}

/** Returns the addresses of the branches on the same parent as a branch, or of all trunks. */
export function siblingsOf({ byAddress, trunks }: Branches, { parent }: Branch): readonly string[] {
	return parent === undefined ? trunks : (byAddress.get(parent)?.children ?? []);
}

/** Returns the length of a line, metres. */
export function lengthOf(line: readonly EditPoint[]): number {
	return line.slice(1).reduce((sum, point, i) => sum + distance(point, line[i]), 0);
}

/** Returns the point at a share 0 … 1 of a line's length. */
export function pointAt(line: readonly EditPoint[], share: number): EditPoint {
	let left = share * lengthOf(line);
	for (let i = 1; i < line.length; i++) {
		const length = distance(line[i - 1], line[i]);
		if (left <= length && length > 0) {
			const along = left / length;
			return [0, 1, 2].map((k) => line[i - 1][k] + along * (line[i][k] - line[i - 1][k])) as unknown as EditPoint;
		}
		left -= length;
	}
	return line[line.length - 1];
}

/** Returns points at even distances along a line, without its first, relative to it. */
export function evenPoints(line: readonly EditPoint[], count: number): readonly EditPoint[] {
	return Array.from({ length: count }, (_, i) => minus(pointAt(line, (i + 1) / count), line[0]));
}

/**
 * Bends a branch: moves one of its points to a place, and the others in proportion, while the base stays.
 * @param at share of its length of the point that moves: 1 the tip
 */
export function bent(line: readonly EditPoint[], at: number, to: EditPoint, count: number): readonly EditPoint[] {
	const moved = minus(to, pointAt(line, at));
	return evenPoints(line, count).map((point, i) => {
		const share = (i + 1) / count;
		// The tip bends the branch ever more from its base on; a point in the middle leaves both ends.
		const weight = at === 1 ? share ** 1.5 : Math.sin(Math.PI * share);
		return [0, 1, 2].map((k) => point[k] + weight * moved[k]) as unknown as EditPoint;
	});
}

/** Returns the difference a − b of two points. */
const minus = (a: EditPoint, b: EditPoint): EditPoint => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
/** Returns the distance between two points. */
const distance = (a: EditPoint, b: EditPoint): number => Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
