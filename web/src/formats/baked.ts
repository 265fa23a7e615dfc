/**
 * Bakes vertex colours, shade, and detail finer than vertices into pictures, for programs that paint, and readers
 * without vertex colours. Parts of one material share pictures, with a tile each: colours under an open sky, shade with
 * roughness (and no metal) as glTF packs them, and normals where any part of the material has a relief. Only for parts
 * whose texture coordinates stay within one picture.
 */
import { type Colour, encoded } from "../plant/colour";
import type { Material } from "../plant/material";
import { everyPart, type Part, type PartMesh, type Shape, type SurfaceDetail, type Vector } from "../plant/part";
import { bounced } from "../plant/shade";
import { Atlas, type Paint } from "./atlas";
import { tangentsOf } from "./tangents";

type Kind = "colour" | "surface" | "normal";

/**
 * Returns the parts with vertex colours and sky of bakeable shapes drawn into textures: one atlas for each material,
 * one tile for each shape. Other shapes stay as they are.
 */
export async function baked(parts: readonly Part[]): Promise<Part[]> {
	const byMaterial = new Map<Material, Shape[]>();
	for (const { shape } of everyPart(parts)) {
		if (!shape || !isBakeable(shape)) continue;
		byMaterial.set(shape.material, [...(byMaterial.get(shape.material) ?? []), shape]);
	}
	const replaced = new Map<Shape, Shape>();
	for (const [material, shapes] of byMaterial) {
		const details = await Promise.all(shapes.map((shape) => shape.loadDetail?.()));
		const relief = details.some((each) => each?.relief);
		const atlas = new Atlas<Kind>(relief ? ["colour", "surface", "normal"] : ["colour", "surface"], shapes.length);
		const dressed = { ...material, textures: atlas.pictures };
		for (const [tile, shape] of shapes.entries()) {
			const { colours: _colours, sky: _sky, ...bare } = shape.mesh;
			const mesh = { ...bare, uvs: atlas.placed(bare.uvs, tile) };
			atlas.draw(bare.uvs, bare.indices, tile, painterOf(shape, mesh, details[tile]));
			const { loadDetail: _loadDetail, ...plain } = shape;
			replaced.set(shape, { ...plain, mesh, material: dressed });
		}
	}
	return parts.map((part) => withShapes(part, replaced));
}

/** Returns a part and its children with their shapes replaced. */
function withShapes(part: Part, replaced: ReadonlyMap<Shape, Shape>): Part {
	const { shape, children } = part;
	return {
		...part,
		...(shape ? { shape: replaced.get(shape) ?? shape } : {}),
		...(children ? { children: children.map((child) => withShapes(child, replaced)) } : {}),
	};
}

/** Returns whether a shape has vertex colours, no textures, no copies, and texture coordinates within one picture. */
function isBakeable({ mesh, material, instances }: Shape): boolean {
	const { colours, uvs } = mesh;
	if (!colours || instances || material.textures || uvs.length === 0) return false;
	return uvs.every((value) => value >= 0 && value <= 1);
}

/** Colour of the mesh's own normal in a normal map. */
const FLAT = [128, 128, 255];

/**
 * Returns a function that computes the colours of a shape's pixels: colour, surface (sky, roughness, no metal), normal.
 * @param mesh the shape's mesh with its final texture coordinates
 * @param detail relief and roughness finer than vertices, if the shape has any
 */
function painterOf(
	{ mesh: { colours, sky }, material }: Shape,
	mesh: PartMesh,
	detail: SurfaceDetail | undefined,
): Paint<Kind> {
	const open = opennessOf(sky, material.colour);
	const frame = detail?.relief ? frameOf(mesh) : undefined;
	return (corners, weights) => {
		const among = (values: ArrayLike<number>, width: number, k: number) =>
			weights.reduce((sum, weight, i) => sum + weight * values[width * corners[i] + k], 0);
		const colour = [0, 1, 2].map((k) => (colours ? among(colours, 3, k) : 0)) as Colour;
		const { roughness, normal } = detail?.at(corners, weights) ?? { roughness: material.roughness };
		return {
			colour: encoded(colour).map(byte),
			surface: [open ? byte(among(open, 1, 0)) : 255, byte(roughness), 0],
			normal: frame && normal ? frame(among, normal) : FLAT,
		};
	};
}

/** Converts a share, 0 … 1, to a byte. */
const byte = (value: number) => Math.round(255 * value);

type Among = (values: ArrayLike<number>, width: number, k: number) => number;

/**
 * Returns a function that writes a normal in the frame of the file's tangents (Gram–Schmidt: right, up, out), as 0 …
 * 255 for −1 … 1, green up the picture.
 */
function frameOf(mesh: PartMesh): (among: Among, normal: Vector) => number[] {
	const tangents = tangentsOf(mesh);
	return (among, normal) => {
		const own = unit([among(mesh.normals, 3, 0), among(mesh.normals, 3, 1), among(mesh.normals, 3, 2)]);
		const raw: Vector = [among(tangents, 4, 0), among(tangents, 4, 1), among(tangents, 4, 2)];
		const out = dot(raw, own);
		const right = unit(raw.map((value, k) => value - out * own[k]) as Vector);
		const side = among(tangents, 4, 3) < 0 ? -1 : 1;
		const up = cross(own, right).map((value) => side * value) as Vector;
		return [right, up, own].map((axis) => Math.round(127.5 + 127.5 * dot(normal, axis)));
	};
}

/** Returns the dot product of two vectors. */
const dot = (a: Vector, b: Vector) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

/** Returns the cross product of two vectors. */
function cross([ax, ay, az]: Vector, [bx, by, bz]: Vector): Vector {
	return [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx];
}

/** Returns a vector of length 1 in the same direction; a zero vector stays. */
function unit(vector: Vector): Vector {
	const length = Math.hypot(...vector) || 1;
	return [vector[0] / length, vector[1] / length, vector[2] / length];
}

/**
 * Returns the share of ambient light that shade leaves at each vertex, with the light bounced between surfaces of the
 * colour; undefined without computed sky.
 */
function opennessOf(sky: Uint8Array | undefined, colour: Colour): Float32Array | undefined {
	const albedo = (colour[0] + colour[1] + colour[2]) / 3;
	return sky && Float32Array.from(sky, (value) => Math.min(1, bounced(value / 255, albedo)));
}
