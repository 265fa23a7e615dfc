/** Three.js objects of the octahedron: lines, faint faces, handles of constant size on the screen. */
import {
	BufferAttribute,
	BufferGeometry,
	type Camera,
	type ColorRepresentation,
	DoubleSide,
	Group,
	LineBasicMaterial,
	LineSegments,
	Mesh,
	MeshBasicMaterial,
	SphereGeometry,
} from "three";
import { handleVector } from "./handle_ray";
import { type BunchShape, HANDLES, type Handle } from "./handles";

export interface OctahedronColours {
	line: ColorRepresentation;
	handle: ColorRepresentation;
	/** Rim around a handle, which contrasts with the background. */
	rim: ColorRepresentation;
}

const COLOURS: OctahedronColours = { line: "#2b2622", handle: "#7b1e3a", rim: "#faf6ee" };

/** Vertices in the order p1 … p6; the eight faces counter-clockwise seen from outside. */
const FACES = [0, 4, 2, 0, 2, 5, 0, 5, 3, 0, 3, 4, 1, 2, 4, 1, 5, 2, 1, 3, 5, 1, 4, 3];
const EDGES = [0, 2, 0, 3, 0, 4, 0, 5, 1, 2, 1, 3, 1, 4, 1, 5, 2, 4, 4, 3, 3, 5, 5, 2];

/** Radii on the screen, in CSS pixels. */
const DOT = 5;
const RIM = 7;
const HIGHLIGHT = 1.35;

/** Drawn after the bunch, in this order. */
const ORDER = { faces: 10, hidden: 11, lines: 12, rim: 13, dot: 14 };

export class OctahedronRenderer {
	readonly object = new Group();
	readonly #canvas: HTMLCanvasElement;
	readonly #corners = new BufferAttribute(new Float32Array(3 * 6), 3);
	readonly #sphere = new SphereGeometry(1, 16, 12);
	readonly #handles = new Map<Handle, Group>();
	readonly #faceMaterial = new MeshBasicMaterial({
		transparent: true,
		opacity: 0.05,
		side: DoubleSide,
		depthWrite: false,
		toneMapped: false,
	});
	/** Edges behind the bunch still show through, fainter. */
	readonly #lineMaterials = [
		new LineBasicMaterial({ transparent: true, opacity: 0.22, depthTest: false, depthWrite: false, toneMapped: false }),
		new LineBasicMaterial({ transparent: true, opacity: 0.6, depthWrite: false, toneMapped: false }),
	];
	readonly #rimMaterial = new MeshBasicMaterial({ transparent: true, depthTest: false, toneMapped: false });
	readonly #dotMaterial = new MeshBasicMaterial({ transparent: true, depthTest: false, toneMapped: false });

	/** @param canvas its size on the screen keeps the handles' size constant */
	constructor(canvas: HTMLCanvasElement) {
		this.#canvas = canvas;
		this.object.name = "octahedron";
		const faces = new Mesh(this.#geometry(FACES), this.#faceMaterial);
		const edges = this.#geometry(EDGES);
		const [hidden, lines] = this.#lineMaterials.map((material) => new LineSegments(edges, material));
		faces.renderOrder = ORDER.faces;
		hidden.renderOrder = ORDER.hidden;
		lines.renderOrder = ORDER.lines;
		for (const part of [faces, hidden, lines]) part.frustumCulled = false;
		this.object.add(faces, hidden, lines);
		for (const handle of HANDLES) {
			const group = new Group();
			group.name = handle;
			group.add(this.#ball(this.#rimMaterial, RIM, ORDER.rim), this.#ball(this.#dotMaterial, DOT, ORDER.dot));
			this.#handles.set(handle, group);
			this.object.add(group);
		}
		this.setColours(COLOURS);
	}

	/** Moves corners and handles to a profile. */
	update(parameters: BunchShape & { unit: number }): void {
		for (const [index, handle] of HANDLES.entries()) {
			const place = handleVector(parameters, handle, parameters.unit);
			this.#corners.setXYZ(index + 1, ...place);
			this.#handles.get(handle)?.position.set(...place);
		}
		this.#corners.needsUpdate = true;
	}

	/** Enlarges one handle, the one under the pointer. */
	highlight(highlighted: Handle | undefined): void {
		for (const [handle, group] of this.#handles) group.userData.factor = handle === highlighted ? HIGHLIGHT : 1;
	}

	/** Sets the colours of lines, faces and handles. */
	setColours({ line, handle, rim }: OctahedronColours): void {
		for (const material of [this.#faceMaterial, ...this.#lineMaterials]) material.color.set(line);
		this.#dotMaterial.color.set(handle);
		this.#rimMaterial.color.set(rim);
	}

	/** Releases the graphics memory. */
	dispose(): void {
		for (const part of this.object.children)
			if (part instanceof Mesh || part instanceof LineSegments) part.geometry.dispose();
		this.#sphere.dispose();
		const materials = [this.#faceMaterial, ...this.#lineMaterials, this.#rimMaterial, this.#dotMaterial];
		for (const material of materials) material.dispose();
	}

	/**
	 * Creates a geometry of the shared corners.
	 * @param index corners of its triangles or edges
	 */
	#geometry(index: number[]): BufferGeometry {
		return new BufferGeometry().setAttribute("position", this.#corners).setIndex(index);
	}

	/** Creates a sphere that is scaled just before it is drawn, so that it keeps its size on the screen. */
	#ball(material: MeshBasicMaterial, pixels: number, order: number): Mesh {
		const ball = new Mesh(this.#sphere, material);
		ball.renderOrder = order;
		ball.frustumCulled = false;
		ball.onBeforeRender = (_renderer, _scene, camera) => {
			const factor: number = ball.parent?.userData.factor ?? 1;
			ball.scale.setScalar(pixels * factor * this.#metresPerScreenPixel(ball, camera));
			ball.updateMatrixWorld(true);
		};
		return ball;
	}

	/** Returns metres per CSS pixel at the sphere's depth, for perspective and orthographic cameras. */
	#metresPerScreenPixel(ball: Mesh, camera: Camera): number {
		const { elements } = camera.projectionMatrix;
		const view = camera.matrixWorldInverse.elements;
		const [x, y, z] = ball.matrixWorld.elements.slice(12, 15);
		const depth = view[2] * x + view[6] * y + view[10] * z + view[14];
		const clipW = elements[11] * depth + elements[15];
		return (2 * clipW) / (elements[5] * Math.max(this.#canvas.clientHeight, 1));
	}
}
