/** Draws the bounding shells of a plant: faint faces, and edges between them. */
import {
	type BufferAttribute,
	BufferGeometry,
	DoubleSide,
	EdgesGeometry,
	Float32BufferAttribute,
	Group,
	LineBasicMaterial,
	LineSegments,
	Mesh,
	MeshBasicMaterial,
} from "three";

/** Least angle between faces at which an edge is drawn, degrees. */
const EDGE = 20;
/** Drawn after the plant. */
const ORDER = 10;

/** A closed surface, metres. */
export interface Shell {
	/** 3 × points. */
	points: number[];
	/** 3 × triangles. An identical array means the same body, moved, rotated or stretched. */
	triangles: number[];
}

/** Edges by the array of triangles, two points each. */
const known = new WeakMap<readonly number[], number[]>();

/**
 * Returns the indices of the points that edges join, two per edge. Finding edges takes longer than showing a plant, so
 * a body that is only moved or stretched reuses its edges.
 */
function edgesOf(faces: BufferGeometry, triangles: readonly number[]): number[] {
	const before = known.get(triangles);
	if (before) return before;
	const position = faces.attributes.position as BufferAttribute;
	const points = new Map<string, number>();
	const keyOf = ({ array }: BufferAttribute, i: number) => `${array[3 * i]} ${array[3 * i + 1]} ${array[3 * i + 2]}`;
	for (let i = 0; i < position.count; i++) points.set(keyOf(position, i), i);
	const found = new EdgesGeometry(faces, EDGE).attributes.position as BufferAttribute;
	const edges = Array.from({ length: found.count }, (_, i) => points.get(keyOf(found, i)) ?? 0);
	known.set(triangles, edges);
	return edges;
}

export class ShellRenderer {
	readonly object = new Group();
	readonly #faces = new MeshBasicMaterial({
		transparent: true,
		opacity: 0.08,
		side: DoubleSide,
		depthWrite: false,
		toneMapped: false,
	});
	readonly #edges = new LineBasicMaterial({ transparent: true, opacity: 0.4, depthWrite: false, toneMapped: false });

	/** Materials of marked shells. */
	readonly #markedFaces = this.#faces.clone();
	readonly #markedEdges = this.#edges.clone();

	constructor() {
		this.object.name = "boundary";
		this.#markedFaces.opacity = 0.15;
		this.#markedEdges.opacity = 1;
	}

	/**
	 * Replaces the shells.
	 * @param colour any CSS colour
	 */
	show(shells: readonly Shell[], colour: string): void {
		this.#clear();
		for (const material of [this.#faces, this.#edges]) material.color.set(colour);
		for (const { points, triangles } of shells) {
			const position = new Float32BufferAttribute(points, 3);
			const faces = new BufferGeometry().setAttribute("position", position).setIndex(triangles);
			const edges = new BufferGeometry().setAttribute("position", position).setIndex(edgesOf(faces, triangles));
			const parts = [new Mesh(faces, this.#faces), new LineSegments(edges, this.#edges)];
			for (const part of parts) part.renderOrder = ORDER;
			this.object.add(...parts);
		}
	}

	/**
	 * Draws some shells more strongly, and all others normally.
	 * @param marked indices of the marked shells
	 * @param colour any CSS colour
	 */
	mark(marked: ReadonlySet<number>, colour: string): void {
		for (const material of [this.#markedFaces, this.#markedEdges]) material.color.set(colour);
		this.object.children.forEach((part, index) => {
			// Each shell has two children: faces and edges.
			const isMarked = marked.has(index >> 1);
			if (part instanceof Mesh) part.material = isMarked ? this.#markedFaces : this.#faces;
			else (part as LineSegments).material = isMarked ? this.#markedEdges : this.#edges;
		});
	}

	/** Frees the shells and all materials; the caller removes `object` from its scene. */
	dispose(): void {
		this.#clear();
		this.#faces.dispose();
		this.#edges.dispose();
		this.#markedFaces.dispose();
		this.#markedEdges.dispose();
	}

	/** Removes all shells and frees their geometries. */
	#clear(): void {
		for (const part of this.object.children) (part as Mesh).geometry.dispose();
		this.object.clear();
	}
}
