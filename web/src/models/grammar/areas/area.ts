/** Growth areas: the volumes that clip a text's plant (docs/models/grammar/topiary.md). */
import type { ClosedMesh } from "../../../specimen/closed_mesh";

/** Kinds in the core's order (wasm-core/src/spatial/volume.hpp). */
export const AREA_KINDS = ["box", "sphere", "ellipsoid", "cylinder", "cone", "mesh"] as const;
export type AreaKind = (typeof AREA_KINDS)[number];

export type Triple = readonly [x: number, y: number, z: number];
export type AreaRotation = readonly [x: number, y: number, z: number, w: number];

export const UNTURNED: AreaRotation = [0, 0, 0, 1];

export interface Area {
	readonly kind: AreaKind;
	/** Metres. */
	readonly centre: Triple;
	/** Size of the box that it fills before it is rotated, metres; a sphere's three sizes are equal. */
	readonly size: Triple;
	/** Unit quaternion. */
	readonly rotation: AreaRotation;
	/** Mesh of an area of kind `mesh`, in any unit: it is scaled to `size`. Links do not contain it. */
	readonly mesh?: ClosedMesh;
}

/** Areas and main branch of a specimen. */
export interface WithAreas {
	/** Areas in the order in which the main branch passes them; absent if there are none. */
	areas?: readonly Area[];
	/** Drawn path of the main branch, metres: x, y, z of each place; absent if it leads from centre to centre. */
	path?: readonly number[];
	/**
	 * For each place of the path, the place before it, counted from 1, 0 for the foot; absent if the branch does not
	 * fork.
	 */
	from?: readonly number[];
}

/** Limits of areas and places, so that links and the panel stay usable. */
export const MAX_AREAS = 24;
export const MAX_PATH = 60;
/** Metres. */
export const FARTHEST = 100;
export const SMALLEST = 0.01;

/** Rotates a vector by a unit quaternion. */
export function rotate([x, y, z]: Triple, [qx, qy, qz, qw]: AreaRotation): Triple {
	const [tx, ty, tz] = [2 * (qy * z - qz * y), 2 * (qz * x - qx * z), 2 * (qx * y - qy * x)];
	return [x + qw * tx + qy * tz - qz * ty, y + qw * ty + qz * tx - qx * tz, z + qw * tz + qx * ty - qy * tx];
}

/** Rotates by degrees about an axis, after another rotation. */
export function rotateFurther([bx, by, bz, bw]: AreaRotation, axis: Triple, degrees: number): AreaRotation {
	const half = (degrees * Math.PI) / 360;
	const [ax, ay, az] = axis.map((value) => value * Math.sin(half));
	const aw = Math.cos(half);
	return unit([
		aw * bx + ax * bw + ay * bz - az * by,
		aw * by - ax * bz + ay * bw + az * bx,
		aw * bz + ax * by - ay * bx + az * bw,
		aw * bw - ax * bx - ay * by - az * bz,
	]);
}

/** Converts a rotation to the angles that users type: degrees about Y, then X, then Z. */
export function degreesOf([x, y, z, w]: AreaRotation): Triple {
	const clamp = (value: number) => Math.max(-1, Math.min(1, value));
	const sine = clamp(2 * (w * x - y * z));
	const angles =
		Math.abs(sine) < 0.99999
			? [
					Math.asin(sine),
					Math.atan2(2 * (w * y + x * z), 1 - 2 * (x * x + y * y)),
					Math.atan2(2 * (w * z + x * y), 1 - 2 * (x * x + z * z)),
				]
			: [Math.asin(sine), 2 * Math.atan2(y, w), 0];
	const [about_x, about_y, about_z] = angles.map((angle) => Math.round((angle * 1800) / Math.PI) / 10 + 0);
	return [about_x, about_y, about_z];
}

/** Converts degrees about Z, then X, then Y, all axes of the world, to a rotation. */
export function rotationOf([x, y, z]: Triple): AreaRotation {
	return rotateFurther(rotateFurther(rotateFurther(UNTURNED, [0, 0, 1], z), [1, 0, 0], x), [0, 1, 0], y);
}

/** Scales a rotation to a unit quaternion with w ≥ 0; a zero one becomes UNTURNED. */
export function unit(q: AreaRotation): AreaRotation {
	const length = Math.hypot(...q);
	if (!(length > 0)) return UNTURNED;
	const sign = q[3] < 0 ? -1 : 1;
	return q.map((value) => (sign * value) / length) as unknown as AreaRotation;
}

/** Converts a point of an area's own box, −1 … 1 on each axis, to metres. */
export function placeIn({ centre, size, rotation }: Area, own: Triple): Triple {
	const [x, y, z] = rotate([0.5 * own[0] * size[0], 0.5 * own[1] * size[1], 0.5 * own[2] * size[2]], rotation);
	return [centre[0] + x, centre[1] + y, centre[2] + z];
}
