/**
 * Natural berries that share meshes, for files that draw instances: of each step of ripeness and of shade one berry, the least
 * pressed, stands for all. What is lost: where each is pressed, its own tint and patches; size, place and direction stay.
 */
import { meanColour } from "../../../plant/colour";
import { fromUp, placeVectors, rows } from "../../../plant/orientation";
import { type Part, type PartMesh, TRANSFORM } from "../../../plant/part";
import type { Berries, BerrySurfaces, Grown } from "../grown";
import type { Look } from "../specimen";
import { meanOf } from "../traits";
import { flowersTogether, GROUP, placeOf, ripenessStep } from "./berries";
import { type Painted, paintedBerries } from "./berry_colour";
import { naturalSkin } from "./materials";
import { bunchSkin } from "./skin";

/** Steps of shade, from the inside of the bunch to its outside. */
const SHADES = 4;
const ORIGIN = [0, 0, 0] as const;

export function classedBerries(grown: Grown, surfaces: BerrySurfaces, look: Look): Part {
	const { berries } = grown;
	const skin = bunchSkin(grown, look);
	const painted = paintedBerries(grown, surfaces, skin);
	const material = naturalSkin(look, skin.fruit, meanColour(painted.colours), meanOf(berries, "width", 0));
	const classes = new Map<string, number[]>();
	for (let i = 0; i < berries.count; i++) {
		const shade = Math.min(SHADES - 1, Math.floor(SHADES * skyOf(painted, surfaces, i)));
		const key = `${GROUP} ${ripenessStep(berries, i)} % ripe, ${shade + 1} of ${SHADES} in light`;
		classes.set(key, [...(classes.get(key) ?? []), i]);
	}
	const children = [...classes].map(([name, members]): Part => {
		const mesh = { ...sharedMesh(grown, surfaces, painted, members), name };
		return { name, shape: { mesh, material, instances: { transforms: placesOf(berries, members) } } };
	});
	return { name: GROUP, children: [...children, ...flowersTogether(grown)] };
}

function placesOf(berries: Berries, members: readonly number[]): Float32Array {
	const transforms = new Float32Array(TRANSFORM * members.length);
	for (const [k, i] of members.entries()) transforms.set(placeOf(berries, i, 1), TRANSFORM * k);
	return transforms;
}

/** The one that is pressed least, of unit radius and facing +Y, in the mean shade of all. */
function sharedMesh(
	{ berries }: Grown,
	surfaces: BerrySurfaces,
	{ colours, ...painted }: Painted,
	members: readonly number[],
): PartMesh {
	const { uvs, indices, positions, normals, pressed } = surfaces;
	const vertices = uvs.length / 2;
	const own = (index: number) => sum(pressed.subarray(vertices * index, vertices * (index + 1)));
	const index = members.reduce((best, each) => (own(each) < own(best) ? each : best));
	const [x, y, z, radius] = berries.spheres.subarray(4 * index, 4 * index + 4);
	const { x: qx, y: qy, z: qz, w } = fromUp(...direction(berries, index));
	// Back from where it faces, about its centre.
	const back = rows({ x: -qx, y: -qy, z: -qz, w });
	const [first, last] = [3 * vertices * index, 3 * vertices * (index + 1)];
	const about = positions.slice(first, last).map((value, i) => value - [x, y, z][i % 3]);
	const mesh = { positions: new Float32Array(3 * vertices), normals: new Float32Array(3 * vertices) };
	placeVectors(about, back, 1 / radius, ORIGIN, mesh.positions);
	placeVectors(normals.subarray(first, last), back, 1, ORIGIN, mesh.normals);
	const open = members.reduce((all, each) => all + skyOf(painted, surfaces, each), 0) / members.length;
	const sky = new Uint8Array(vertices).fill(Math.round(255 * open));
	return { ...mesh, uvs, indices, colours: colours.slice(first, last), sky };
}

/** The share of the sky that a berry sees in the mean. */
function skyOf({ sky }: Pick<Painted, "sky">, { uvs }: BerrySurfaces, index: number): number {
	const vertices = uvs.length / 2;
	return sky ? sum(sky.subarray(vertices * index, vertices * (index + 1))) / (255 * vertices) : 1;
}

const direction = ({ directions }: Berries, index: number): [x: number, y: number, z: number] => {
	const [x, y, z] = directions.subarray(3 * index, 3 * index + 3);
	return [x, y, z];
};

const sum = (values: Uint8Array) => values.reduce((all, value) => all + value, 0);
