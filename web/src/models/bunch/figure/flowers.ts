import {
	BufferAttribute,
	BufferGeometry,
	type Group,
	InstancedBufferAttribute,
	InstancedMesh,
	type MeshStandardMaterial,
} from "three";
import { matrixOf } from "../../../scene/part_meshes";
import type { Grown } from "../grown";
import { placeOf, stamenColours } from "../parts/berries";
import { openFlowers } from "../parts/flowers";

/** The open flowers: instances of one mesh of stamens about their ovaries, which are the berries. */
export class Flowers {
	readonly #group: Group;
	readonly #material: MeshStandardMaterial;
	#drawn: InstancedMesh<BufferGeometry, MeshStandardMaterial> | undefined;

	constructor(group: Group, material: MeshStandardMaterial) {
		this.#group = group;
		this.#material = material;
	}

	/**
	 * Puts a bunch's flowers in place of the last one's. They come and go with the age; nothing is kept of them.
	 * @param skies share of the sky that each berry sees (skiesOf); all of it where absent
	 */
	show({ flower, berries }: Grown, skies?: Float32Array): void {
		this.dispose();
		const open = flower ? openFlowers(berries) : new Float32Array(0);
		if (!flower || open.length === 0) return;
		const count = open.length / 2;
		const geometry = new BufferGeometry();
		geometry.setAttribute("position", new BufferAttribute(flower.positions, 3));
		geometry.setAttribute("normal", new BufferAttribute(flower.normals, 3));
		geometry.setAttribute("color", new BufferAttribute(stamenColours(flower), 3));
		geometry.setIndex(new BufferAttribute(flower.indices, 1));
		const bearer = new Float32Array(count);
		const sky = new Float32Array(count);
		const drawn = new InstancedMesh(geometry, this.#material, count);
		for (let i = 0; i < count; i++) {
			const berry = open[2 * i];
			drawn.setMatrixAt(i, matrixOf(Float32Array.from(placeOf(berries, berry, open[2 * i + 1])), 0));
			bearer[i] = berry;
			sky[i] = skies?.[berry] ?? 1;
		}
		geometry.setAttribute("bearer", new InstancedBufferAttribute(bearer, 1));
		geometry.setAttribute("sky", new InstancedBufferAttribute(sky, 1));
		drawn.name = "flowers";
		drawn.frustumCulled = false;
		this.#group.add(drawn);
		this.#drawn = drawn;
	}

	set visible(visible: boolean) {
		if (this.#drawn) this.#drawn.visible = visible;
	}

	dispose(): void {
		this.#drawn?.removeFromParent();
		this.#drawn?.geometry.dispose();
		this.#drawn?.dispose();
		this.#drawn = undefined;
	}
}
