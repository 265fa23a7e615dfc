/**
 * Points on a plant's surface as binary PLY: position, normal, colour, and part of each point, for work with scans.
 * Metres, +Y up.
 *
 * `instance` counts the nodes with a mesh of the *detailed* GLB, from 0, in their order. `class` is the number of the
 * part's kind, which comments of the header name. A model may add an id of its own (`PointLabels`).
 */
import { encoded } from "../plant/colour";
import type { Part } from "../plant/part";
import type { About, PointLabels } from "./about";
import { GENERATOR } from "./generator";
import type { Cover } from "./hidden";
import { coverOf } from "./light";
import { type NamedPiece, type Piece, piecesOf } from "./piece";
import { together } from "./together";
import { plainBase } from "./vertex_colours";

/**
 * Bytes of a point: six floats, three bytes of colour; then 32 bits and 16 of its label, and 32 of an id if there is
 * one.
 */
const [LABEL, ID, WITH_ID] = [27, 33, 37];

/** The part of a point. */
interface Label {
	readonly instance: number;
	readonly kind: number;
	/** Undefined where the model has none. */
	readonly id: number | undefined;
}

/**
 * Writes points of a plant's surface.
 * @param points their number, spread evenly over all visible surface
 */
export function ply(parts: Iterable<Part>, about: About, points: number): Uint8Array<ArrayBuffer> {
	// Counted as nodes of a GLB: instances in one node there are one here.
	const all = [...piecesOf([...parts].map(together))];
	const kinds = kindsOf(all, about.labels?.classes);
	const cover = coverOf(
		all.map((piece, instance) => ({ ...piece, label: labelOf(piece, instance, kinds, about.labels) })),
	);
	const cloud = cloudOf(cover, points);
	const properties = ["x", "y", "z", "nx", "ny", "nz"].map((name) => `property float ${name}`);
	const colours = ["red", "green", "blue"].map((name) => `property uchar ${name}`);
	const id = about.labels ? [`int ${about.labels.id.property}`] : [];
	const size = about.labels ? WITH_ID : ID;
	const labels = ["int instance", "ushort class", ...id].map((each) => `property ${each}`);
	const words = [
		"ply",
		"format binary_little_endian 1.0",
		`comment ${GENERATOR}: ${about.name}, metres, +Y up`,
		`comment ${about.link}`,
		...kinds.map((kind, number) => `comment class ${number} ${kind}`),
		`element vertex ${cloud.count}`,
		...[...properties, ...colours, ...labels, "end_header"],
	];
	const header = new TextEncoder().encode(`${words.join("\n")}\n`);
	const file = new Uint8Array(header.length + size * cloud.count);
	file.set(header);
	const view = new DataView(file.buffer, header.length);
	for (let index = 0; index < cloud.count; index++) writePoint(view, size * index, cloud.at(index));
	return file;
}

/** A point on a triangle of a piece. */
interface Point {
	readonly piece: Labelled;
	/** Vertices of the triangle. */
	readonly corners: Uint32Array;
	/** Weights of the corners; they sum to 1. */
	readonly weights: readonly [number, number, number];
}

type Labelled = Piece & { readonly label: Label };

/** The least share of visible points on candidate triangles: below it all candidates count as visible. */
const LEAST_VISIBLE = 0.05;
/** Factor of additional points, so that a second pass is enough. */
const SPARE = 1.02;

/** Points on triangles, all numbers by index: a cloud may have millions. */
class Candidates {
	/** For each point, the index of its piece, and of its triangle in that piece. */
	readonly #places: Uint32Array;
	/** 0 where there is no area. */
	readonly count: number;

	/** Places one point in the middle of each equal share of the area. */
	constructor(
		readonly pieces: readonly Labelled[],
		areas: readonly Float64Array[],
		count: number,
	) {
		this.#places = new Uint32Array(2 * count);
		const whole = areas.reduce((sum, own) => sum + own.reduce((all, area) => all + area, 0), 0);
		let [passed, point] = [0, 0];
		for (const [piece, own] of areas.entries()) {
			for (const [triangle, area] of own.entries()) {
				passed += area;
				for (; point < count && (point + 0.5) * whole <= passed * count; point++)
					this.#places.set([piece, triangle], 2 * point);
			}
		}
		this.count = point;
	}

	/**
	 * Returns a point within its triangle. Multiples of STEPS modulo 1 spread the points evenly; points beyond the
	 * triangle's diagonal are mirrored into it.
	 */
	at(index: number): Point {
		let [s, t] = STEPS.map((step) => (step * (index + 1)) % 1);
		if (s + t > 1) [s, t] = [1 - s, 1 - t];
		const [piece, triangle] = this.#places.subarray(2 * index, 2 * index + 2);
		const { indices } = this.pieces[piece].mesh;
		const corners = indices.subarray(3 * triangle, 3 * triangle + 3);
		return { piece: this.pieces[piece], corners, weights: [1 - s - t, s, t] };
	}
}

interface Cloud {
	readonly count: number;
	at(index: number): Point;
}

/** Returns a cloud of points, spread evenly over all visible surface: large triangles may be partly hidden. */
function cloudOf(cover: Cover<Labelled>, points: number): Cloud {
	const pieces = cover.visible();
	const areas = pieces.map(areasOf);
	const allCandidates = new Candidates(pieces, areas, points);
	let candidates = allCandidates;
	while (candidates.count > 0) {
		const visible = new Uint32Array(candidates.count);
		let visibleCount = 0;
		for (let i = 0; i < visible.length; i++) if (!isHidden(cover, candidates.at(i))) visible[visibleCount++] = i;
		const [from, first] = [candidates, visibleCount];
		if (visibleCount >= points)
			return { count: points, at: (index) => from.at(visible[Math.floor(((index + 0.5) * first) / points)]) };
		if (visibleCount < LEAST_VISIBLE * visible.length) break;
		candidates = new Candidates(pieces, areas, Math.ceil((SPARE * visible.length * points) / visibleCount) + 1);
	}
	return allCandidates;
}

/** Returns whether a point is inside another piece, or where another piece touches its own. */
function isHidden(cover: Cover<Labelled>, point: Point): boolean {
	const { positions } = point.piece.mesh;
	return cover.hides(point.piece.label.instance, meanOf(positions, point), normalAt(point));
}

/** Interpolates values with three numbers per vertex at a point. */
function meanOf(values: Float32Array, { corners, weights }: Point): number[] {
	return [0, 1, 2].map((k) =>
		weights.reduce((sum, weight, corner) => sum + weight * values[3 * corners[corner] + k], 0),
	);
}

/** Returns the unit normal at a point. */
function normalAt(point: Point): number[] {
	const normal = meanOf(point.piece.mesh.normals, point);
	const length = Math.hypot(...normal) || 1;
	return normal.map((value) => value / length);
}

/** Returns the kind of a part: its name without the trailing number. */
const kindOf = ({ name }: Pick<NamedPiece, "name">) => name.replace(/ [\d.]+$/, "");

/** Returns the kinds of parts by class number: the known ones, then the others in order of appearance. */
function kindsOf(pieces: readonly NamedPiece[], known: readonly string[] = []): string[] {
	return [...new Set([...known, ...pieces.map(kindOf)])];
}

/**
 * Returns the label of the points on a piece.
 * @param instance index of the piece
 */
function labelOf(piece: NamedPiece, instance: number, kinds: readonly string[], labels?: PointLabels): Label {
	const id = labels ? (labels.id.of(piece) ?? -1) : undefined;
	return { instance, kind: kinds.indexOf(kindOf(piece)), id };
}

/** Returns the areas of the triangles. */
function areasOf({ mesh: { positions: p, indices } }: Piece): Float64Array {
	return Float64Array.from({ length: indices.length / 3 }, (_, triangle) => {
		const [a, b, c] = [3 * indices[3 * triangle], 3 * indices[3 * triangle + 1], 3 * indices[3 * triangle + 2]];
		const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
		const [vx, vy, vz] = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
		return Math.hypot(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx) / 2;
	});
}

/**
 * The generalised golden ratio of two dimensions: its multiples fill a square evenly (Roberts 2018, "The unreasonable
 * effectiveness of quasirandom sequences").
 */
const STEPS = [0.7548776662466927, 0.5698402909980532] as const;

/**
 * Writes one point: position, normal, colour, labels.
 * @param at offset of the point's bytes
 */
function writePoint(view: DataView, at: number, point: Point): void {
	const { mesh, material, label } = point.piece;
	// The mean of a picture replaces it; vertex colours multiply it.
	const factor = material.textures?.colour && mesh.colours ? material.colour : [1, 1, 1];
	const base = mesh.colours || !material.textures?.colour ? plainBase(material) : material.colour;
	const [red, green, blue] = mesh.colours ? meanOf(mesh.colours, point).map((value, k) => value * factor[k]) : base;
	const shown = encoded([red, green, blue]);
	const [position, normal] = [meanOf(mesh.positions, point), normalAt(point)];
	for (let k = 0; k < 3; k++) {
		view.setFloat32(at + 4 * k, position[k], true);
		view.setFloat32(at + 12 + 4 * k, normal[k], true);
		view.setUint8(at + 24 + k, Math.round(255 * Math.max(0, Math.min(1, shown[k]))));
	}
	view.setInt32(at + LABEL, label.instance, true);
	view.setUint16(at + LABEL + 4, label.kind, true);
	if (label.id !== undefined) view.setInt32(at + ID, label.id, true);
}
