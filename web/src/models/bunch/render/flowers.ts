import {
	BufferAttribute,
	BufferGeometry,
	type Group,
	InstancedBufferAttribute,
	InstancedMesh,
	type MeshStandardMaterial,
} from "three";
import { cut, TRANSFORM } from "../../../plant/part";
import { matrixOf } from "../../../render/part_meshes";
import type { BunchPlant, FlowerMesh, FlowerPiece } from "../bunch_plant";
import { flowersOf, type PlacedPieces } from "../parts/flowers";
import { flowerColours } from "../parts/foliage_colour";

type PieceMesh = InstancedMesh<BufferGeometry, MeshStandardMaterial>;

/** Renders flowers: one instanced mesh per kind of piece. */
export class Flowers {
	readonly #group: Group;
	readonly #material: MeshStandardMaterial;
	#meshes: PieceMesh[] = [];

	constructor(group: Group, material: MeshStandardMaterial) {
		this.#group = group;
		this.#material = material;
	}

	/**
	 * Replaces the flowers by another bunch's. They appear and disappear with age; nothing is reused.
	 * @param skies sky visibility of each berry (skiesOf); all of the sky if absent
	 */
	show(grown: BunchPlant, skies?: Float32Array): void {
		this.dispose();
		const { flower } = grown;
		if (!flower) return;
		const all = flowersOf(grown);
		for (const run of flower.pieces) {
			const pieces = all.filter(({ piece }) => piece === run.piece);
			if (pieces.length > 0) this.#meshes.push(this.#createMesh(run.piece, geometryOf(flower, run), pieces, skies));
		}
		if (this.#meshes.length > 0) this.#group.add(...this.#meshes);
	}

	/**
	 * Creates an instanced mesh of one piece, such as all petals; each instance knows its berry (`ownerBerry`) and the
	 * sky that it sees.
	 */
	#createMesh(piece: FlowerPiece, geometry: BufferGeometry, pieces: PlacedPieces[], skies?: Float32Array): PieceMesh {
		const transforms = Float32Array.from(pieces.flatMap((each) => each.transforms));
		const owners = pieces.flatMap((each) =>
			each.transforms.slice(0, each.transforms.length / TRANSFORM).fill(each.berry),
		);
		const mesh = new InstancedMesh(geometry, this.#material, owners.length);
		for (let i = 0; i < owners.length; i++) mesh.setMatrixAt(i, matrixOf(transforms, i));
		geometry.setAttribute("ownerBerry", new InstancedBufferAttribute(Float32Array.from(owners), 1));
		const sky = Float32Array.from(owners, (berry) => skies?.[berry] ?? 1);
		geometry.setAttribute("sky", new InstancedBufferAttribute(sky, 1));
		mesh.name = piece;
		mesh.frustumCulled = false;
		return mesh;
	}

	/** Shows or hides all flowers. */
	set visible(visible: boolean) {
		for (const each of this.#meshes) each.visible = visible;
	}

	/** Removes the flowers and releases their graphics memory. */
	dispose(): void {
		for (const each of this.#meshes) {
			each.removeFromParent();
			each.geometry.dispose();
			each.dispose();
		}
		this.#meshes = [];
	}
}

/** Creates the geometry of one piece of the flower's mesh. */
function geometryOf(flower: FlowerMesh, run: FlowerMesh["pieces"][number]): BufferGeometry {
	const { positions, normals, uvs, indices } = cut(flower, run);
	const geometry = new BufferGeometry();
	geometry.setAttribute("position", new BufferAttribute(positions, 3));
	geometry.setAttribute("normal", new BufferAttribute(normals, 3));
	geometry.setAttribute("color", new BufferAttribute(flowerColours(uvs), 3));
	geometry.setIndex(new BufferAttribute(indices, 1));
	return geometry;
}
