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

	constructor() {
		this.object.name = "boundary";
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

	dispose(): void {
		this.#clear();
		this.#faces.dispose();
		this.#edges.dispose();
	}

	#clear(): void {
		for (const part of this.object.children) (part as Mesh).geometry.dispose();
		this.object.clear();
	}
}
