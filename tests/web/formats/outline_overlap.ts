/** How much of the outlines of two plants is the same, drawn without any code of the page. */
import { Box3, type Mesh, Vector3 } from "three";

/** Along the longest edge of the box about the first plant. */
const PIXELS = 256;
const VIEWS = [
	["x", "y"],
	["z", "y"],
	["x", "z"],
] as const;

/** Intersection over union of the pixels that the plants cover, in the view along an axis where it is least. */
export function outlineOverlap(one: readonly Mesh[], other: readonly Mesh[]): number {
	const box = new Box3();
	for (const mesh of one) box.expandByObject(mesh, true);
	const pixel = Math.max(...box.getSize(new Vector3()).toArray()) / PIXELS;
	const shares = VIEWS.map((view) => {
		const [first, second] = [one, other].map((meshes) => covered(meshes, view, box.min, pixel));
		const both = [...first].filter((at) => second.has(at)).length;
		return both / (first.size + second.size - both);
	});
	return Math.min(...shares);
}

/** The pixels whose middle a triangle covers. */
function covered(meshes: readonly Mesh[], [across, up]: (typeof VIEWS)[number], low: Vector3, pixel: number) {
	const pixels = new Set<number>();
	const point = new Vector3();
	for (const { geometry, matrixWorld } of meshes) {
		const { position } = geometry.attributes;
		const corner = (index: number) => {
			point.fromBufferAttribute(position, geometry.index?.getX(index) ?? index).applyMatrix4(matrixWorld);
			return [(point[across] - low[across]) / pixel - 0.5, (point[up] - low[up]) / pixel - 0.5] as const;
		};
		for (let at = 0; at < (geometry.index?.count ?? position.count); at += 3) {
			const corners = [corner(at), corner(at + 1), corner(at + 2)] as const;
			const [us, vs] = [corners.map(([u]) => u), corners.map(([, v]) => v)];
			for (let v = Math.ceil(Math.min(...vs)); v <= Math.max(...vs); v++)
				for (let u = Math.ceil(Math.min(...us)); u <= Math.max(...us); u++)
					if (holds(corners, u, v)) pixels.add((v + PIXELS) * 4 * PIXELS + u + PIXELS);
		}
	}
	return pixels;
}

function holds(corners: readonly (readonly [u: number, v: number])[], u: number, v: number): boolean {
	const sides = corners.map(([fromU, fromV], k) => {
		const [toU, toV] = corners[(k + 1) % 3];
		return (toU - fromU) * (v - fromV) - (toV - fromV) * (u - fromU);
	});
	return sides.every((side) => side >= 0) || sides.every((side) => side <= 0);
}
