/**
 * Makes similar bodies share meshes: for each material, variant and step of shade, the body that sees most of the sky
 * replaces all others, placed by `pose`. The differences between bodies get lost: their deformation, tint and patches.
 */
import { placeVectors, rotationMatrix } from "../plant/orientation";
import { everyPart, type Part, type PartMesh, type Shape, TRANSFORM } from "../plant/part";

/** Steps of shade, from the inside of a plant to its outside. */
const SHADES = 4;
const ORIGIN = [0, 0, 0] as const;

type Posed = Shape & Required<Pick<Shape, "pose">>;

/**
 * Returns the part with one part per class of posed bodies in a group, and the children of those bodies beside them.
 */
export function alike(part: Part): Part {
	const { children } = part;
	if (!children) return part;
	const posed = children.flatMap(({ shape }) => (shape?.pose ? [shape as Posed] : []));
	const others = children.filter(({ shape }) => !shape?.pose).map(alike);
	const attached = children.filter(({ shape }) => shape?.pose).flatMap((child) => child.children ?? []);
	return { ...part, children: [...classesOf(part.name, posed), ...others, ...joinInstances(attached)] };
}

/**
 * Groups posed bodies by variant and step of shade; each class becomes one part with one mesh and an instance per body.
 * `group` begins the names of these parts.
 */
function classesOf(group: string, shapes: readonly Posed[]): Part[] {
	const classes = new Map<string, Posed[]>();
	for (const shape of shapes) {
		const step = Math.min(SHADES - 1, Math.floor(SHADES * skyShareOf(shape.mesh)));
		const key = `${group}${shape.variant ? `, ${shape.variant}` : ""}, ${step + 1} of ${SHADES} in light`;
		classes.set(key, [...(classes.get(key) ?? []), shape]);
	}
	return [...classes].map(([name, members]) => {
		const transforms = Float32Array.from(members.flatMap(({ pose }) => [...pose]));
		return {
			name,
			shape: { mesh: { ...sharedMesh(members), name }, material: members[0].material, instances: { transforms } },
		};
	});
}

/** Joins instances of the same mesh and material, from several parts, into one part; other parts stay as they are. */
function joinInstances(parts: readonly Part[]): Part[] {
	const others: Part[] = [];
	const groups: Shape[][] = [];
	for (const { children: _, ...part } of everyPart(parts)) {
		const { shape } = part;
		if (!shape?.instances) {
			if (shape) others.push(part);
			continue;
		}
		const group = groups.find(([{ mesh, material }]) => mesh === shape.mesh && material === shape.material);
		if (group) group.push(shape);
		else groups.push([shape]);
	}
	const shared = groups.map((shapes) => {
		const transforms = Float32Array.from(shapes.flatMap(({ instances }) => [...(instances?.transforms ?? [])]));
		const [{ mesh, material }] = shapes;
		const name = mesh.name ?? "Shared";
		const isShared = groups.filter(([other]) => other.mesh === mesh).length > 1;
		return {
			name: `${name}${isShared ? `, ${material.name},` : ""} of all`,
			shape: { ...shapes[0], instances: { transforms } },
		};
	});
	return [...others, ...shared];
}

/** Returns the mesh of the most open body, of unit size and facing +Y, in the mean shade of all. */
function sharedMesh(members: readonly Posed[]): PartMesh {
	const { mesh, pose } = members.reduce((best, each) => (skyShareOf(each.mesh) > skyShareOf(best.mesh) ? each : best));
	const [x, y, z, qx, qy, qz, qw, size] = pose.subarray(0, TRANSFORM);
	const inverseRotation = rotationMatrix({ x: -qx, y: -qy, z: -qz, w: qw });
	const centred = mesh.positions.map((value, i) => value - [x, y, z][i % 3]);
	const unitMesh = { positions: new Float32Array(centred.length), normals: new Float32Array(centred.length) };
	placeVectors(centred, inverseRotation, 1 / size, ORIGIN, unitMesh.positions);
	placeVectors(mesh.normals, inverseRotation, 1, ORIGIN, unitMesh.normals);
	const meanSky = members.reduce((sum, each) => sum + skyShareOf(each.mesh), 0) / members.length;
	return { ...mesh, ...unitMesh, sky: new Uint8Array(centred.length / 3).fill(Math.round(255 * meanSky)) };
}

/** Returns the mean share of the sky that a mesh sees, 0 … 1. */
function skyShareOf({ sky }: PartMesh): number {
	return sky ? sky.reduce((sum, value) => sum + value, 0) / (255 * sky.length) : 1;
}
