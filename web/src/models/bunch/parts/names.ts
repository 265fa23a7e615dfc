/**
 * Names of a file's nodes in an outliner: the same in GLB and OBJ. Numbers start at 1 and are padded, so that sorting
 * by name keeps their order.
 */
import type { FlowerPiece, FoliagePart } from "../bunch_plant";

/** Returns the name of a part of the stem: `Rachis` for −1, else `Axis 01` for s = 0 (the top one) and so on. */
export function stemName(axis: number): string {
	return axis < 0 ? "Rachis" : `Axis ${String(axis + 1).padStart(2, "0")}`;
}

/** Returns the name of berry `index` (from 0) of `count`: `Berry 001`; more digits above 999. */
export function berryName(index: number, count: number): string {
	return `Berry ${berryNumber(index, count)}`;
}

const PIECE_TITLES = { stamens: "Flower", cap: "Cap", pistil: "Pistil", petals: "Petals", calyx: "Calyx" } as const;

/** Returns the title of a piece of a flower: the stamens, its most visible part, are called the flower. */
export function pieceTitle(piece: FlowerPiece): string {
	return PIECE_TITLES[piece];
}

/**
 * Returns the name of a piece of the flower of berry `index`: `Flower 001`, `Cap 001`; of those beside it `Flower
 * 001.2` and so on.
 * @param sideFlower 0 for the berry's own flower, from 1 for those beside it
 */
export function pieceName(piece: FlowerPiece, index: number, count: number, sideFlower: number): string {
	return `${pieceTitle(piece)} ${berryNumber(index, count)}${sideFlower > 0 ? `.${sideFlower + 1}` : ""}`;
}

/** Returns the number of a berry, from 1, padded with zeros to at least three digits. */
function berryNumber(index: number, count: number): string {
	return String(index + 1).padStart(Math.max(3, String(count).length), "0");
}

const FOLIAGE_NAMES = { cane: "Cane", leaf: "Leaf", petiole: "Petiole" } as const;

/** Returns the names of foliage's parts, in their order: `Cane`, `Leaf 1`, `Petiole 1`, `Leaf 2` … */
export function foliageNames(parts: readonly FoliagePart[]): string[] {
	const seen = new Map<string, number>();
	return parts.map(({ kind }) => {
		const number = (seen.get(kind) ?? 0) + 1;
		seen.set(kind, number);
		return kind === "cane" && number === 1 ? FOLIAGE_NAMES.cane : `${FOLIAGE_NAMES[kind]} ${number}`;
	});
}
