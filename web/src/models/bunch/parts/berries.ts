/** Parts of a bunch's berries: a group with one part per berry, with its flower until it has set. */
import { type Colour, linear, meanColour } from "../../../plant/colour";
import type { Material } from "../../../plant/material";
import { fromUp } from "../../../plant/orientation";
import { cut, type Extras, type Part, type PartMesh, type Shape, TRANSFORM } from "../../../plant/part";
import type { Mesh } from "../../../plant/plant";
import type { Berries, BerrySurfaces, BunchPlant, FlowerPiece } from "../bunch_plant";
import { meanOf, traitOf } from "../traits";
import { type Painted, paintedBerries, scarShare } from "./berry_colour";
import { flowersOf } from "./flowers";
import { flowerColours } from "./foliage_colour";
import { FLOWERS, naturalSkin, plainSkin } from "./materials";
import { berryName, pieceName, pieceTitle } from "./names";
import { type BunchDress, bunchSkin } from "./skin";

const GROUP = "Berries";
/** Step of ripeness, percent, in formats without colours of vertices. */
const RIPENESS_STEP = 25;
/** Factor on the shared berry's colour at the scar and the dried style: a brown over any skin. */
const SCAR_TINT: Colour = [0.42, 0.3, 0.2];

/** Returns the paper's berries: instances of one mesh of unit radius with the scar towards +Y. */
export function sharedBerries(grown: BunchPlant, berry: Mesh, dress: BunchDress): Part {
	const { look } = dress;
	const { berries } = grown;
	const transforms = new Float32Array(TRANSFORM * berries.count);
	for (let i = 0; i < berries.count; i++) transforms.set(placeOf(berries, i, 1), TRANSFORM * i);
	const each = (i: number) => ({ name: berryName(i, berries.count), extras: parentOf(grown, i) });
	const mesh = {
		...berry,
		name: "Berry",
		colours: scarredColours(berry, linear(look.skin), bunchSkin(grown, dress).fruit.scar),
	};
	return { name: GROUP, shape: { mesh, material: plainSkin(look), instances: { transforms, each } } };
}

/**
 * Returns natural berries, each with its own surface around its own centre; all share texture coordinates and
 * triangles.
 */
export function naturalBerries(grown: BunchPlant, surfaces: BerrySurfaces, dress: BunchDress): Part {
	const { berries } = grown;
	const skin = bunchSkin(grown, dress);
	const painted = paintedBerries(grown, surfaces, skin);
	const material = naturalSkin(dress.look, skin.fruit, meanColour(painted.colours), meanOf(berries, "width", 0));
	const flowers = flowersByBerry(grown);
	const children = Array.from({ length: berries.count }, (_, i): Part => {
		const flowerParts = flowers.get(i);
		return {
			name: berryName(i, berries.count),
			shape: {
				...berryShape(grown, i, surfaces, painted, material),
				loadDetail: async () => (await import("./berry_finer")).berryFiner(grown, i, surfaces, skin),
			},
			extras: berryExtras(grown, i),
			...(flowerParts ? { children: flowerParts } : {}),
		};
	});
	return { name: GROUP, children };
}

/** Returns the shape of one berry with surfaces of its own. */
function berryShape(
	{ berries }: BunchPlant,
	index: number,
	{ uvs, indices, positions, normals }: BerrySurfaces,
	{ colours, sky }: Painted,
	material: Material,
): Shape {
	const [first, last] = [(index * 3 * uvs.length) / 2, ((index + 1) * 3 * uvs.length) / 2];
	const [x, y, z] = berries.spheres.subarray(4 * index, 4 * index + 4);
	const ofBerry = (values: Float32Array) => values.subarray(first, last);
	const percent = RIPENESS_STEP * Math.round((100 * traitOf(berries, index, "turned")) / RIPENESS_STEP);
	return {
		mesh: {
			positions: ofBerry(positions),
			normals: ofBerry(normals),
			uvs,
			indices,
			colours: ofBerry(colours),
			...(sky ? { sky: sky.subarray(first / 3, last / 3) } : {}),
		},
		material,
		centre: [x, y, z],
		pose: Float32Array.from(placeOf(berries, index, 1)),
		variant: percent === 100 ? "" : String(percent),
	};
}

/** Returns the pedicel of a berry, and the pedicel's axis. */
function parentOf({ berries, internodes }: BunchPlant, index: number): Extras {
	const pedicel = berries.parent[index];
	return { pedicel, axis: internodes.axis[pedicel] };
}

/** Returns the data of one berry, shown when a viewer selects it; lengths in metres. */
function berryExtras(grown: BunchPlant, index: number): Extras {
	const { berries } = grown;
	const trait = (name: Parameters<typeof traitOf>[2]) => traitOf(berries, index, name);
	return {
		id: berries.ids[index],
		...parentOf(grown, index),
		radius: berries.spheres[4 * index + 3],
		width: trait("width"),
		length: trait("length"),
		direction: Array.from(berries.directions.subarray(3 * index, 3 * index + 3)),
		exposure: trait("exposure"),
		turned: trait("turned"),
	};
}

/** Returns flowers and calyces by their berries' indices; all pieces of a kind share one mesh. */
function flowersByBerry(grown: BunchPlant): Map<number, Part[]> {
	const parts = new Map<number, Part[]>();
	const { flower, berries } = grown;
	if (!flower) return parts;
	const meshes = new Map<FlowerPiece, PartMesh>();
	for (const run of flower.pieces) {
		const mesh = cut(flower, run);
		meshes.set(run.piece, { ...mesh, name: pieceTitle(run.piece), colours: flowerColours(mesh.uvs) });
	}
	for (const { piece, berry, transforms } of flowersOf(grown)) {
		const mesh = meshes.get(piece);
		const ofBerry = parts.get(berry) ?? [];
		parts.set(berry, ofBerry);
		for (let at = 0; mesh && at < transforms.length; at += TRANSFORM) {
			const instances = { transforms: Float32Array.from(transforms.slice(at, at + TRANSFORM)) };
			const name = pieceName(piece, berry, berries.count, at / TRANSFORM);
			ofBerry.push({ name, shape: { mesh, material: FLOWERS, instances } });
		}
	}
	return parts;
}

/** Returns the transform that takes a body of unit radius facing +Y to berry `index`, `scale` times its radius. */
export function placeOf({ spheres, directions }: Berries, index: number, scale: number): number[] {
	const [x, y, z, radius] = spheres.subarray(4 * index, 4 * index + 4);
	const turn = fromUp(directions[3 * index], directions[3 * index + 1], directions[3 * index + 2]);
	return [x, y, z, turn.x, turn.y, turn.z, turn.w, scale * radius];
}

/**
 * Returns the vertices' colours of one skin, browned at the tip scar: 3 × vertices.
 * @param scar value of v from which on the scar lies
 */
function scarredColours({ uvs }: Mesh, skin: Colour, scar: number): Float32Array {
	return coloursByV(uvs, (v) => {
		const share = scarShare(v, scar);
		return skin.map((value, k) => value * (1 + (SCAR_TINT[k] - 1) * share)) as Colour;
	});
}

/** Returns the vertices' colours, which depend on v (second number of each uv) only: 3 × vertices. */
function coloursByV(uvs: Float32Array, colourAt: (v: number) => Colour): Float32Array {
	const colours = new Float32Array(1.5 * uvs.length);
	for (let vertex = 0; vertex < uvs.length / 2; vertex++) colours.set(colourAt(uvs[2 * vertex + 1]), 3 * vertex);
	return colours;
}
