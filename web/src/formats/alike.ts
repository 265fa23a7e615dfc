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

/** The part, with one part per class of posed bodies in a group, and the children of those bodies beside them. */
export function alike(part: Part): Part {
	const { children } = part;
	if (!children) return part;
	const posed = children.flatMap(({ shape }) => (shape?.pose ? [shape as Posed] : []));
	const others = children.filter(({ shape }) => !shape?.pose).map(alike);
	const attached = children.filter(({ shape }) => shape?.pose).flatMap((child) => child.children ?? []);
	return { ...part, children: [...classesOf(part.name, posed), ...others, ...joined(attached)] };
}

function classesOf(group: string, shapes: readonly Posed[]): Part[] {
	const classes = new Map<string, Posed[]>();
	for (const shape of shapes) {
		const step = Math.min(SHADES - 1, Math.floor(SHADES * openOf(shape.mesh)));
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

/** Instances of one mesh and material, of several parts, as one part; what is no instance as it is. */
function joined(parts: readonly Part[]): Part[] {
	const others: Part[] = [];
	const alike: Shape[][] = [];
	for (const { children: _, ...part } of everyPart(parts)) {
		const { shape } = part;
		if (!shape?.instances) {
			if (shape) others.push(part);
			continue;
		}
		const same = alike.find(([{ mesh, material }]) => mesh === shape.mesh && material === shape.material);
		if (same) same.push(shape);
		else alike.push([shape]);
	}
	const shared = alike.map((shapes) => {
		const transforms = Float32Array.from(shapes.flatMap(({ instances }) => [...(instances?.transforms ?? [])]));
		const [{ mesh, material }] = shapes;
		const name = mesh.name ?? "Shared";
		const worn = alike.filter(([other]) => other.mesh === mesh).length > 1;
		return {
			name: `${name}${worn ? `, ${material.name},` : ""} of all`,
			shape: { ...shapes[0], instances: { transforms } },
		};
	});
	return [...others, ...shared];
}

/** The mesh of the most open body, of unit size and facing +Y, in the mean shade of all. */
function sharedMesh(members: readonly Posed[]): PartMesh {
	const { mesh, pose } = members.reduce((best, each) => (openOf(each.mesh) > openOf(best.mesh) ? each : best));
	const [x, y, z, qx, qy, qz, qw, size] = pose.subarray(0, TRANSFORM);
	const back = rotationMatrix({ x: -qx, y: -qy, z: -qz, w: qw });
	const about = mesh.positions.map((value, i) => value - [x, y, z][i % 3]);
	const own = { positions: new Float32Array(about.length), normals: new Float32Array(about.length) };
	placeVectors(about, back, 1 / size, ORIGIN, own.positions);
	placeVectors(mesh.normals, back, 1, ORIGIN, own.normals);
	const open = members.reduce((sum, each) => sum + openOf(each.mesh), 0) / members.length;
	return { ...mesh, ...own, sky: new Uint8Array(about.length / 3).fill(Math.round(255 * open)) };
}

/** The mean share of the sky that a mesh sees. */
function openOf({ sky }: PartMesh): number {
	return sky ? sky.reduce((sum, value) => sum + value, 0) / (255 * sky.length) : 1;
}
