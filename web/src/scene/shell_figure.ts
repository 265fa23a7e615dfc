/** What bounds a plant, in the 3-D view: faint, and its edges where it has any. */
import {
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

/** Between faces at least so far apart an edge is drawn, degrees. */
const EDGE = 20;
/** Drawn after the plant. */
const ORDER = 10;

/** A closed surface, metres. */
export interface Shell {
	/** 3 × points. */
	points: number[];
	/** 3 × triangles. */
	triangles: number[];
}

export class ShellFigure {
	readonly object = new Group();
	readonly #faces = new MeshBasicMaterial({
		transparent: true,
		opacity: 0.08,
		side: DoubleSide,
		depthWrite: false,
		toneMapped: false,
	});
	readonly #edges = new LineBasicMaterial({ transparent: true, opacity: 0.4, depthWrite: false, toneMapped: false });

	/** Of those marked. */
	readonly #markedFaces = this.#faces.clone();
	readonly #markedEdges = this.#edges.clone();

	constructor() {
		this.object.name = "boundary";
		this.#markedFaces.opacity = 0.15;
		this.#markedEdges.opacity = 1;
	}

	/** @param colour any CSS colour */
	show(shells: readonly Shell[], colour: string): void {
		this.#clear();
		for (const material of [this.#faces, this.#edges]) material.color.set(colour);
		for (const { points, triangles } of shells) {
			const geometry = new BufferGeometry();
			geometry.setAttribute("position", new Float32BufferAttribute(points, 3)).setIndex(triangles);
			const parts = [new Mesh(geometry, this.#faces), new LineSegments(new EdgesGeometry(geometry, EDGE), this.#edges)];
			for (const part of parts) part.renderOrder = ORDER;
			this.object.add(...parts);
		}
	}

	/** @param marked which of the shells shown, counted from 0; @param colour any CSS colour */
	mark(marked: ReadonlySet<number>, colour: string): void {
		for (const material of [this.#markedFaces, this.#markedEdges]) material.color.set(colour);
		this.object.children.forEach((part, at) => {
			const its = marked.has(at >> 1);
			if (part instanceof Mesh) part.material = its ? this.#markedFaces : this.#faces;
			else (part as LineSegments).material = its ? this.#markedEdges : this.#edges;
		});
	}

	dispose(): void {
		this.#clear();
		this.#faces.dispose();
		this.#edges.dispose();
		this.#markedFaces.dispose();
		this.#markedEdges.dispose();
	}

	#clear(): void {
		for (const part of this.object.children) (part as Mesh).geometry.dispose();
		this.object.clear();
	}
}
