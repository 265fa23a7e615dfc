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

/** Returns the bounding box of points and spheres; empty if there are none. */
export function boxOf({ spheres, points }: Bodies): Box3 {
	const { min, max } = new Box3();
	const extend = (x: number, y: number, z: number, reach: number) => {
		min.set(Math.min(min.x, x - reach), Math.min(min.y, y - reach), Math.min(min.z, z - reach));
		max.set(Math.max(max.x, x + reach), Math.max(max.y, y + reach), Math.max(max.z, z + reach));
	};
	for (let i = 0; i < points.length; i += 3) extend(points[i], points[i + 1], points[i + 2], 0);
	for (let i = 0; i < spheres.length; i += 4) extend(spheres[i], spheres[i + 1], spheres[i + 2], spheres[i + 3]);
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

/**
 * Returns a bounding sphere per instance (x y z radius): its origin, and `reach` times its scale.
 * @param transforms position, quaternion and scale of each instance
 * @param reach greatest distance of the mesh's points from its origin
 */
function ballsOf(transforms: Float32Array, reach: number): Float32Array {
	const count = transforms.length / TRANSFORM;
	const balls = new Float32Array(4 * count);
	for (let i = 0; i < count; i++) {
		const first = TRANSFORM * i;
		balls[4 * i] = transforms[first];
		balls[4 * i + 1] = transforms[first + 1];
		balls[4 * i + 2] = transforms[first + 2];
		balls[4 * i + 3] = reach * transforms[first + 7];
	}
	return balls;
}

/** Concatenates arrays. */
export function joined(arrays: readonly Float32Array[]): Float32Array {
	const whole = new Float32Array(arrays.reduce((length, array) => length + array.length, 0));
	let written = 0;
	for (const array of arrays) {
		whole.set(array, written);
		written += array.length;
	}
	return whole;
}

/** Adds at most about `POINTS` points of a mesh, evenly spaced among its vertices. */
function addPoints(points: number[], positions: Float32Array): void {
	const step = 3 * Math.max(1, Math.floor(positions.length / 3 / POINTS));
	for (let index = 0; index < positions.length; index += step)
		points.push(positions[index], positions[index + 1], positions[index + 2]);
}
