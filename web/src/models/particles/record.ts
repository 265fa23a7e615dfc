/** What the JSON document says of trails, in place of what it says of any segments. */
import { shortFloat } from "../../export/numbers";
import type { TrailPlant } from "./trails";

type Vector = [x: number, y: number, z: number];

/** A piece of trail. */
export interface TrailRecord {
	/** Index of the piece nearer the target, which comes earlier; −1 at a target. */
	parent: number;
	/** By the model's own names. */
	kind: string;
	/** The end nearer the target; metres. */
	start: Vector;
	end: Vector;
	/** That passes. */
	energy: number;
	/** At the start, metres. */
	radius: number;
	radiusEnd: number;
}

/** Where trails end. */
export interface TargetRecord {
	x: number;
	y: number;
	z: number;
	/** That has arrived. */
	energy: number;
}

/** `counts.energy` is what arrived at all targets, exact where energies are whole. */
export function trailRecord(plant: TrailPlant): {
	counts: Record<string, number>;
	segments: TrailRecord[];
	targets: TargetRecord[];
} {
	const { segments, energy, targets, arrived, counts } = plant;
	const pieces = Array.from({ length: segments.count }, (_, i): TrailRecord => {
		const [ax, ay, az, bx, by, bz] = Array.from(segments.ends.subarray(6 * i, 6 * i + 6), shortFloat);
		return {
			parent: segments.parent[i],
			kind: segments.tags[segments.tag[i]],
			start: [ax, ay, az],
			end: [bx, by, bz],
			energy: shortFloat(energy[i]),
			radius: shortFloat(segments.radii[2 * i]),
			radiusEnd: shortFloat(segments.radii[2 * i + 1]),
		};
	});
	const ends = Array.from(arrived, (value, i): TargetRecord => {
		const [x, y, z] = Array.from(targets.subarray(3 * i, 3 * i + 3), shortFloat);
		return { x, y, z, energy: shortFloat(value) };
	});
	const sum = ends.reduce((total, target) => total + target.energy, 0);
	return { counts: { ...counts, energy: sum }, segments: pieces, targets: ends };
}
