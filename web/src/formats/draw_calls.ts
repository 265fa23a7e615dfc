/** Merges pieces into draw calls: one mesh per material, and no more materials than a limit. */
import type { Colour } from "../plant/colour";
import type { Material } from "../plant/material";
import type { PartMesh } from "../plant/part";
import type { Piece } from "./piece";
import { plainBase } from "./vertex_colours";

/** One draw call. */
interface Call {
	material: Material;
	/** Each with the colour that multiplies its colours. */
	pieces: { piece: Piece; tint: Colour }[];
}

const WHITE: Colour = [1, 1, 1];

/**
 * Merges pieces into one per draw call, in the order of first use of the materials; at most `most` (1 or more). Where
 * there are more materials, the most similar ones are merged: the one that covers less gets the finish and the pictures
 * of the other, each part in its own colour.
 */
export function drawCalls(pieces: Iterable<Piece>, most: number): Piece[] {
	const kinds = new Map<Material, Call>();
	for (const piece of pieces) {
		const call = kinds.get(piece.material) ?? { material: piece.material, pieces: [] };
		call.pieces.push({ piece, tint: WHITE });
		kinds.set(piece.material, call);
	}
	const calls = [...kinds.values()];
	while (calls.length > most) joinNearest(calls);
	return calls.map(merged);
}

/**
 * Merges the two draw calls whose materials differ least, the one with fewer triangles into the other, and removes it
 * from the list.
 */
function joinNearest(calls: Call[]): void {
	let nearest: [Call, Call] = [calls[0], calls[1]];
	let leastDistance = Number.POSITIVE_INFINITY;
	for (const [i, one] of calls.entries()) {
		for (const other of calls.slice(i + 1)) {
			const distance = distanceBetween(one.material, other.material);
			if (distance < leastDistance) [leastDistance, nearest] = [distance, [one, other]];
		}
	}
	const [from, into] = nearest.sort((one, other) => cornersOf(one) - cornersOf(other));
	join(from, into);
	calls.splice(calls.indexOf(from), 1);
}

/** Returns three times the number of triangles of a draw call, to compare sizes. */
const cornersOf = ({ pieces }: Call) => pieces.reduce((sum, { piece }) => sum + piece.mesh.indices.length, 0);

/**
 * Returns the error of drawing one material as the other: first by pictures, then by double-sidedness, then by finish.
 */
function distanceBetween(one: Material, other: Material): number {
	const differs = (of: (material: Material) => unknown, weight: number) => (of(one) === of(other) ? 0 : weight);
	return (
		differs(picturesOf, 8) +
		(one.textures ? 1 : 0) +
		differs(({ doubleSided = false }) => doubleSided, 0.5) +
		differs(({ flesh }) => flesh !== undefined, 2) +
		differs(({ sheet }) => sheet !== undefined, 0.25) +
		differs(({ sheen }) => sheen !== undefined, 0.25) +
		differs(({ clearcoat }) => clearcoat !== undefined, 1) +
		Math.abs(one.roughness - other.roughness)
	);
}

/**
 * Returns the kinds and sizes of a material's pictures as one text: materials that agree in it count as tints of one.
 */
function picturesOf({ textures = {} }: Material): string {
	const { repeats = false, colour, normal, thickness } = textures;
	const sizes = [colour, normal, thickness].map((picture) => picture && `${picture.width}×${picture.height}`);
	return [repeats, ...sizes].join(" ");
}

/**
 * Adds the pieces of `from` to `into`, whose material they take. If the pictures of both are the same, the pieces'
 * tints make up for the different colour factors; otherwise no pictures are left, and each piece takes the mean colour
 * of its own.
 */
function join(from: Call, into: Call): void {
	const [oldMaterial, newMaterial] = [from.material, into.material];
	const samePictures = picturesOf(oldMaterial) === picturesOf(newMaterial);
	const doubleSided = oldMaterial.doubleSided || newMaterial.doubleSided;
	const { textures, ...finish } = newMaterial;
	into.material = {
		...finish,
		...(samePictures && textures ? { textures } : {}),
		...(doubleSided ? { doubleSided } : {}),
	};
	if (!samePictures) into.pieces = into.pieces.map((each) => withoutPictures(each, newMaterial));
	const tinted = from.pieces.map(({ piece, tint }) => {
		if (!samePictures) return withoutPictures({ piece, tint }, oldMaterial);
		const share = oldMaterial.textures?.colour
			? oldMaterial.colour.map((value, k) => value / (newMaterial.colour[k] || 1))
			: WHITE;
		return { piece, tint: tint.map((value, k) => value * share[k]) as Colour };
	});
	into.pieces.push(...tinted);
}

/** Returns a piece in which vertex colours, the picture's mean colour, replace the picture. */
function withoutPictures({ piece, tint }: Call["pieces"][number], { textures, colour }: Material) {
	if (!textures?.colour) return { piece, tint };
	const { material, mesh } = piece;
	const colours = mesh.colours ?? uniformColours(WHITE, mesh);
	const { textures: _, ...plain } = material;
	return {
		piece: { material: plain, mesh: { ...mesh, colours: scaled(colours, colour) } },
		tint,
	};
}

/**
 * Merges the pieces of a draw call. Texture coordinates are stored for pictures only; all pieces get vertex colours if
 * any has them.
 */
function merged({ material, pieces }: Call): Piece {
	const vertices = pieces.reduce((sum, { piece }) => sum + piece.mesh.positions.length / 3, 0);
	const corners = pieces.reduce((sum, { piece }) => sum + piece.mesh.indices.length, 0);
	const coloured = pieces.some(
		({ piece, tint }) => piece.mesh.colours || tint !== WHITE || plainBase(piece.material) !== plainBase(material),
	);
	const mesh: PartMesh = {
		positions: new Float32Array(3 * vertices),
		normals: new Float32Array(3 * vertices),
		uvs: new Float32Array(material.textures ? 2 * vertices : 0),
		indices: new Uint32Array(corners),
		...(coloured ? { colours: new Float32Array(3 * vertices) } : {}),
		...(pieces.some(({ piece }) => piece.mesh.feet) ? { feet: new Float32Array(3 * vertices) } : {}),
	};
	// Where the next piece begins.
	let [vertex, corner] = [0, 0];
	for (const { piece, tint } of pieces) {
		const { positions, normals, uvs, indices, colours } = piece.mesh;
		mesh.positions.set(positions, 3 * vertex);
		mesh.normals.set(normals, 3 * vertex);
		// Vertices without a fixed point get their own position.
		mesh.feet?.set(piece.mesh.feet ?? positions, 3 * vertex);
		if (material.textures) mesh.uvs.set(uvs, 2 * vertex);
		mesh.colours?.set(scaled(colours ?? uniformColours(plainBase(piece.material), piece.mesh), tint), 3 * vertex);
		for (let i = 0; i < indices.length; i++) mesh.indices[corner + i] = indices[i] + vertex;
		vertex += positions.length / 3;
		corner += indices.length;
	}
	return { material, mesh };
}

/** Returns vertex colours of one colour for a mesh. */
function uniformColours(colour: Colour, { positions }: PartMesh): Float32Array {
	const colours = new Float32Array(positions.length);
	for (let i = 0; i < colours.length; i += 3) colours.set(colour, i);
	return colours;
}

/** Returns vertex colours multiplied by a colour. */
function scaled(colours: Float32Array, by: Colour): Float32Array {
	return by === WHITE ? colours : colours.map((value, i) => value * by[i % 3]);
}
