/** Cards: triangles or rectangles with a cut-out picture of leaves. */
import type { PartMesh, Vector } from "../../plant/part";
import { add, dot, scaled, subtract, unit } from "./vectors";

export interface Card {
	/** Three corners, or four: left, right, and above them left, right. */
	readonly corners: readonly Vector[];
	/** Texture coordinates of the corners, in the atlas. */
	readonly uvs: readonly (readonly [u: number, v: number])[];
	readonly face: Vector;
	/** The place at which it begins, on a stem or nearest to one. */
	readonly anchor: Vector;
	/** The segment of the wood at its anchor. */
	readonly segment: number;
	/** The share of the sky that its leaves see, 0 … 1. */
	readonly sky: number;
}

/** The share of the direction from the middle of the crown in the normals of cards, beside the card's own normal. */
const ROUND = 0.7;
/** Light in full shade, as a share of that under an open sky. */
const DARKEST = 0.35;

const CORNERS = { 3: [0, 1, 2], 4: [0, 1, 2, 2, 1, 3] } as const;

/** Returns the middle of a card. */
export function middleOf({ corners }: Pick<Card, "corners">): Vector {
	return scaled(
		corners.reduce((sum, corner) => add(sum, corner), [0, 0, 0]),
		1 / corners.length,
	);
}

/**
 * Makes the mesh of cards, with the shade as vertex colours.
 * @param crown the middle of the crown, from which normals point away
 */
export function cardMesh(cards: readonly Card[], crown: Vector): PartMesh {
	const vertices = cards.reduce((sum, { corners }) => sum + corners.length, 0);
	const mesh = {
		positions: new Float32Array(3 * vertices),
		normals: new Float32Array(3 * vertices),
		uvs: new Float32Array(2 * vertices),
		colours: new Float32Array(3 * vertices),
		indices: new Uint32Array(cards.reduce((sum, { corners }) => sum + 3 * (corners.length - 2), 0)),
	};
	let [vertex, index] = [0, 0];
	for (const { corners, uvs, face, sky } of cards) {
		for (const corner of CORNERS[corners.length as 3 | 4]) mesh.indices[index++] = vertex + corner;
		for (const [k, corner] of corners.entries()) {
			const away = unit(subtract(corner, crown));
			const front = dot(face, away) < 0 ? scaled(face, -1) : face;
			mesh.positions.set(corner, 3 * vertex);
			mesh.normals.set(unit(add(scaled(away, ROUND), scaled(front, 1 - ROUND))), 3 * vertex);
			mesh.uvs.set(uvs[k], 2 * vertex);
			mesh.colours.fill(DARKEST + (1 - DARKEST) * sky, 3 * vertex, 3 * vertex + 3);
			vertex++;
		}
	}
	return mesh;
}
