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
const MOST_SEGMENTS = 20_000;
const MOST_ORGANS = 4_000;
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
		const lines = thinned(segments, MOST_SEGMENTS);
		const surfaces = thinned(organs, MOST_ORGANS).flatMap((organ) => {
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

	dispose(): void {
		this.#clear();
		this.#tube.dispose();
		for (const each of this.#materials) each.dispose();
	}

	#clear(): void {
		for (const part of this.object.children) {
			if (part instanceof InstancedMesh) part.dispose();
			else (part as Mesh).geometry.dispose();
		}
		this.object.clear();
	}
}

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

function thinned(all: readonly number[], most: number): readonly number[] {
	if (all.length <= most) return all;
	return Array.from({ length: most }, (_, index) => all[Math.floor((index * all.length) / most)]);
}

function tubes(
	tube: BufferGeometry,
	worn: MeshBasicMaterial,
	{ ends, radii }: DrawnGeometry,
	lines: readonly number[],
	thin: number,
): InstancedMesh {
	const mesh = new InstancedMesh(tube, worn, lines.length);
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

function sheetOf(surfaces: readonly Float32Array[]): BufferGeometry {
	const corners = new Float32Array(surfaces.reduce((sum, { length }) => sum + length, 0));
	let at = 0;
	for (const each of surfaces) {
		corners.set(each, at);
		at += each.length;
	}
	return new BufferGeometry().setAttribute("position", new BufferAttribute(corners, 3));
}
