import { Box3, Sphere, Vector3 } from "three";
import { everyPart, type Part, TRANSFORM } from "../plant/part";
import type { Bodies } from "./camera_fit";

/** Largest number of points sampled evenly from a mesh without instances. */
const POINTS = 400;

/** Returns the bounds of parts: points of their meshes, and a sphere about each instance. */
export function boundsOf(parts: Iterable<Part>): Bodies {
	const points: number[] = [];
	const balls: Float32Array[] = [];
	for (const { shape } of everyPart(parts)) {
		if (!shape) continue;
		const { positions } = shape.mesh;
		if (shape.instances) balls.push(ballsOf(shape.instances.transforms, reachOf(positions)));
		else addPoints(points, positions);
	}
	return { spheres: joined(balls), points: Float32Array.from(points) };
}

/** Returns the bounding box; empty if there are no bodies. */
export function boxOf({ spheres, points }: Bodies): Box3 {
	const { min, max } = new Box3();
	const hold = (x: number, y: number, z: number, reach: number) => {
		min.set(Math.min(min.x, x - reach), Math.min(min.y, y - reach), Math.min(min.z, z - reach));
		max.set(Math.max(max.x, x + reach), Math.max(max.y, y + reach), Math.max(max.z, z + reach));
	};
	for (let i = 0; i < points.length; i += 3) hold(points[i], points[i + 1], points[i + 2], 0);
	for (let i = 0; i < spheres.length; i += 4) hold(spheres[i], spheres[i + 1], spheres[i + 2], spheres[i + 3]);
	return new Box3(min, max);
}

/** Returns a bounding sphere about the middle of the bounding box. */
export function ballOf(bodies: Bodies): { centre: Vector3; radius: number } {
	const box = boxOf(bodies);
	if (box.isEmpty()) return { centre: new Vector3(), radius: 0 };
	const { center: centre, radius } = box.getBoundingSphere(new Sphere());
	return { centre, radius };
}

/** Returns the greatest distance of a mesh's points from its origin. */
function reachOf(positions: Float32Array): number {
	let square = 0;
	for (let i = 0; i < positions.length; i += 3) {
		square = Math.max(square, positions[i] ** 2 + positions[i + 1] ** 2 + positions[i + 2] ** 2);
	}
	return Math.sqrt(square);
}

function ballsOf(transforms: Float32Array, reach: number): Float32Array {
	const count = transforms.length / TRANSFORM;
	const balls = new Float32Array(4 * count);
	for (let i = 0; i < count; i++) {
		const at = TRANSFORM * i;
		balls[4 * i] = transforms[at];
		balls[4 * i + 1] = transforms[at + 1];
		balls[4 * i + 2] = transforms[at + 2];
		balls[4 * i + 3] = reach * transforms[at + 7];
	}
	return balls;
}

/** Concatenates arrays. */
export function joined(arrays: readonly Float32Array[]): Float32Array {
	const whole = new Float32Array(arrays.reduce((length, array) => length + array.length, 0));
	let at = 0;
	for (const array of arrays) {
		whole.set(array, at);
		at += array.length;
	}
	return whole;
}

function addPoints(points: number[], positions: Float32Array): void {
	const step = 3 * Math.max(1, Math.floor(positions.length / 3 / POINTS));
	for (let at = 0; at < positions.length; at += step) points.push(positions[at], positions[at + 1], positions[at + 2]);
}
