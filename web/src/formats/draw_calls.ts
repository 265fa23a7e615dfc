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
 * One piece per draw call, in the order of first use of the materials; at most `most` (1 or more). Where there are more
 * materials, the most similar ones are merged: the one that covers less gets the finish and the pictures of the other,
 * each part in its own colour.
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

function joinNearest(calls: Call[]): void {
	let nearest: [Call, Call] = [calls[0], calls[1]];
	let least = Number.POSITIVE_INFINITY;
	for (const [i, one] of calls.entries()) {
		for (const other of calls.slice(i + 1)) {
			const distance = distanceBetween(one.material, other.material);
			if (distance < least) [least, nearest] = [distance, [one, other]];
		}
	}
	const [from, into] = nearest.sort((one, other) => trianglesOf(one) - trianglesOf(other));
	join(from, into);
	calls.splice(calls.indexOf(from), 1);
}

const trianglesOf = ({ pieces }: Call) => pieces.reduce((sum, { piece }) => sum + piece.mesh.indices.length, 0);

/** The error of drawing one material as the other: first by pictures, then by double-sidedness, then by finish. */
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

/** The kinds and sizes of a material's pictures: materials that agree in them count as tints of one. */
function picturesOf({ textures = {} }: Material): string {
	const { repeats = false, colour, normal, thickness } = textures;
	const sizes = [colour, normal, thickness].map((picture) => picture && `${picture.width}×${picture.height}`);
	return [repeats, ...sizes].join(" ");
}

function join(from: Call, into: Call): void {
	const [one, other] = [from.material, into.material];
	const alike = picturesOf(one) === picturesOf(other);
	const doubleSided = one.doubleSided || other.doubleSided;
	const { textures, ...finish } = other;
	into.material = { ...finish, ...(alike && textures ? { textures } : {}), ...(doubleSided ? { doubleSided } : {}) };
	if (!alike) into.pieces = into.pieces.map((each) => withoutPictures(each, other));
	const tinted = from.pieces.map(({ piece, tint }) => {
		if (!alike) return withoutPictures({ piece, tint }, one);
		const share = one.textures?.colour ? one.colour.map((value, k) => value / (other.colour[k] || 1)) : WHITE;
		return { piece, tint: tint.map((value, k) => value * share[k]) as Colour };
	});
	into.pieces.push(...tinted);
}

/** Replaces a dropped picture by its mean colour. */
function withoutPictures({ piece, tint }: Call["pieces"][number], { textures, colour }: Material) {
	if (!textures?.colour) return { piece, tint };
	const { material, mesh } = piece;
	const colours = mesh.colours ?? filled(WHITE, mesh);
	const { textures: _, ...plain } = material;
	return {
		piece: { material: plain, mesh: { ...mesh, colours: scaled(colours, colour) } },
		tint,
	};
}

/** Texture coordinates are stored for pictures only; all pieces get vertex colours where any has them. */
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
	let [vertex, corner] = [0, 0];
	for (const { piece, tint } of pieces) {
		const { positions, normals, uvs, indices, colours } = piece.mesh;
		mesh.positions.set(positions, 3 * vertex);
		mesh.normals.set(normals, 3 * vertex);
		// Vertices without a fixed point get their own position.
		mesh.feet?.set(piece.mesh.feet ?? positions, 3 * vertex);
		if (material.textures) mesh.uvs.set(uvs, 2 * vertex);
		mesh.colours?.set(scaled(colours ?? filled(plainBase(piece.material), piece.mesh), tint), 3 * vertex);
		for (let i = 0; i < indices.length; i++) mesh.indices[corner + i] = indices[i] + vertex;
		vertex += positions.length / 3;
		corner += indices.length;
	}
	return { material, mesh };
}

function filled(colour: Colour, { positions }: PartMesh): Float32Array {
	const colours = new Float32Array(positions.length);
	for (let i = 0; i < colours.length; i += 3) colours.set(colour, i);
	return colours;
}

function scaled(colours: Float32Array, by: Colour): Float32Array {
	return by === WHITE ? colours : colours.map((value, i) => value * by[i % 3]);
}
