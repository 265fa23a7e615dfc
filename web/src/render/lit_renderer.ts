/**
 * Highlights parts of a plant in one colour, drawn over it and faintly visible through parts in front. The plant's own
 * meshes stay unchanged.
 */
import {
	BufferAttribute,
	BufferGeometry,
	CylinderGeometry,
	DoubleSide,
	Group,
	InstancedMesh,
	Matrix4,
	Mesh,
	MeshBasicMaterial,
	Quaternion,
	Vector3,
} from "three";
import { type DrawnGeometry, trianglesOf } from "../plant/drawn";

/** Drawn after the plant. */
const ORDER = 8;
/** Above these numbers, highlights are thinned out evenly. */
const MAX_SEGMENTS = 20_000;
const MAX_ORGANS = 4_000;
/** Radius of a highlight, relative to the part that it covers. */
const WIDER = 1.25;
const UP = new Vector3(0, 1, 0);

export class LitRenderer {
	readonly object = new Group();
	/** Materials of the visible and of the hidden parts. */
	readonly #materials = [material(0.78, true), material(0.22, false)];
	readonly #tube = new CylinderGeometry(1, 1, 1, 8, 1);

	constructor() {
		this.object.name = "lit";
	}

	/**
	 * Replaces the highlights.
	 * @param segments indices of highlighted segments
	 * @param organs indices of highlighted organs
	 * @param thin least visible radius of a segment, metres
	 * @param colour any CSS colour
	 */
	show(
		drawn: DrawnGeometry,
		segments: readonly number[],
		organs: readonly number[],
		thin: number,
		colour: string,
	): void {
		this.#clear();
		for (const each of this.#materials) each.color.set(colour);
		const lines = thinOut(segments, MAX_SEGMENTS);
		const surfaces = thinOut(organs, MAX_ORGANS).flatMap((organ) => {
			const surface = drawn.surface(organ);
			return surface ? [trianglesOf(surface)] : [];
		});
		const sheet = surfaces.length > 0 ? sheetOf(surfaces) : undefined;
		for (const each of this.#materials) {
			if (lines.length > 0) this.object.add(tubes(this.#tube, each, drawn, lines, thin));
			if (sheet) this.object.add(new Mesh(sheet, each));
		}
		for (const part of this.object.children) {
			part.renderOrder = ORDER;
			part.frustumCulled = false;
		}
	}

	/** Frees the highlights and the materials; the caller removes `object` from its scene. */
	dispose(): void {
		this.#clear();
		this.#tube.dispose();
		for (const each of this.#materials) each.dispose();
	}

	/** Removes all highlights and frees their geometries, except the shared tube. */
	#clear(): void {
		for (const part of this.object.children) {
			if (part instanceof InstancedMesh) part.dispose();
			else (part as Mesh).geometry.dispose();
		}
		this.object.clear();
	}
}

/**
 * Creates a highlight's material. With `tested`, parts in front of the highlight cover it; without, it is drawn over
 * them.
 */
function material(opacity: number, tested: boolean): MeshBasicMaterial {
	return new MeshBasicMaterial({
		transparent: true,
		opacity,
		depthTest: tested,
		depthWrite: false,
		side: DoubleSide,
		toneMapped: false,
		// Highlights on a blade are visible from both sides.
		polygonOffset: true,
		polygonOffsetFactor: -2,
		polygonOffsetUnits: -2,
	});
}

/** Returns at most `limit` of the items, evenly spaced. */
function thinOut(items: readonly number[], limit: number): readonly number[] {
	if (items.length <= limit) return items;
	return Array.from({ length: limit }, (_, index) => items[Math.floor((index * items.length) / limit)]);
}

/**
 * Returns one cylinder per segment in `lines` (indices), a little thicker than the segment and at least `thin` in
 * radius, in metres.
 * @param tube cylinder of unit radius and height along +Y
 */
function tubes(
	tube: BufferGeometry,
	highlight: MeshBasicMaterial,
	{ ends, radii }: DrawnGeometry,
	lines: readonly number[],
	thin: number,
): InstancedMesh {
	const mesh = new InstancedMesh(tube, highlight, lines.length);
	const [start, end, middle, size] = [new Vector3(), new Vector3(), new Vector3(), new Vector3()];
	const [turn, matrix] = [new Quaternion(), new Matrix4()];
	lines.forEach((line, index) => {
		start.fromArray(ends, 6 * line);
		end.fromArray(ends, 6 * line + 3);
		middle.addVectors(start, end).multiplyScalar(0.5);
		end.sub(start);
		const length = end.length();
		const radius = Math.max(thin, WIDER * Math.max(radii[2 * line], radii[2 * line + 1]));
		turn.setFromUnitVectors(UP, length > 0 ? end.divideScalar(length) : UP);
		mesh.setMatrixAt(index, matrix.compose(middle, turn, size.set(radius, Math.max(length, thin), radius)));
	});
	return mesh;
}

/**
 * Returns one geometry of triangles without indices: the surfaces' corners, nine numbers per triangle, one after
 * another.
 */
function sheetOf(surfaces: readonly Float32Array[]): BufferGeometry {
	const corners = new Float32Array(surfaces.reduce((sum, { length }) => sum + length, 0));
	let written = 0;
	for (const each of surfaces) {
		corners.set(each, written);
		written += each.length;
	}
	return new BufferGeometry().setAttribute("position", new BufferAttribute(corners, 3));
}
