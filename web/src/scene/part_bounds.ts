import { Box3, Sphere, Vector3 } from "three";
import { everyPart, type Part, TRANSFORM } from "../plant/part";
import type { Bodies } from "./camera_fit";

/** Of a mesh that stands where it is, so many points count, evenly picked; with fewer, all do. */
const POINTS = 400;

/** What parts take up: points of their meshes, and a ball about each instance. */
export function boundsOf(parts: Iterable<Part>): Bodies {
	const points: number[] = [];
	const spheres: number[] = [];
	for (const { shape } of everyPart(parts)) {
		if (!shape) continue;
		const { positions } = shape.mesh;
		if (shape.instances) addBalls(spheres, shape.instances.transforms, reachOf(positions));
		else addPoints(points, positions);
	}
	return { spheres: Float32Array.from(spheres), points: Float32Array.from(points) };
}

/** A ball that holds them, about the middle of their box. */
export function ballOf({ spheres, points }: Bodies): { centre: Vector3; radius: number } {
	const box = new Box3();
	for (let i = 0; i < points.length; i += 3) box.expandByPoint(new Vector3().fromArray(points, i));
	for (let i = 0; i < spheres.length; i += 4) {
		const reach = new Vector3().setScalar(spheres[i + 3]);
		const centre = new Vector3().fromArray(spheres, i);
		box.expandByPoint(centre.clone().add(reach)).expandByPoint(centre.sub(reach));
	}
	if (box.isEmpty()) return { centre: new Vector3(), radius: 0 };
	const { center: centre, radius } = box.getBoundingSphere(new Sphere());
	return { centre, radius };
}

/** How far a mesh reaches from its origin. */
function reachOf(positions: Float32Array): number {
	let square = 0;
	for (let i = 0; i < positions.length; i += 3) {
		square = Math.max(square, positions[i] ** 2 + positions[i + 1] ** 2 + positions[i + 2] ** 2);
	}
	return Math.sqrt(square);
}

function addBalls(spheres: number[], transforms: Float32Array, reach: number): void {
	for (let at = 0; at < transforms.length; at += TRANSFORM) {
		spheres.push(transforms[at], transforms[at + 1], transforms[at + 2], reach * transforms[at + 7]);
	}
}

function addPoints(points: number[], positions: Float32Array): void {
	const step = 3 * Math.max(1, Math.floor(positions.length / 3 / POINTS));
	for (let at = 0; at < positions.length; at += step) points.push(positions[at], positions[at + 1], positions[at + 2]);
}
