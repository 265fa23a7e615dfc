import {
	BufferAttribute,
	BufferGeometry,
	DynamicDrawUsage,
	Group,
	InstancedBufferAttribute,
	InstancedBufferGeometry,
	Mesh,
	type PerspectiveCamera,
	type ShaderMaterial,
	type TypedArray,
	Vector3,
} from "three";
import type { Grown, StemMesh } from "../core/grown";
import { capMesh } from "./berry_material";

const NEAREST_FIRST = new Vector3();

/** The meshes of a bunch: all berries as instances of one, all stems as one. Buffers are kept from bunch to bunch. */
export class BunchSurface {
	readonly group = new Group();
	readonly #berries: Mesh<InstancedBufferGeometry, ShaderMaterial>;
	readonly #stems: Mesh<BufferGeometry, ShaderMaterial>;
	#spheres: Float32Array = new Float32Array(0);
	#count = 0;
	#depths = new Float64Array(0);
	#order: number[] = [];

	constructor(
		readonly berryMaterial: ShaderMaterial,
		readonly stemMaterial: ShaderMaterial,
	) {
		this.#berries = new Mesh(new InstancedBufferGeometry(), berryMaterial);
		this.#berries.name = "berries";
		this.#stems = new Mesh(new BufferGeometry(), stemMaterial);
		this.#stems.name = "stems";
		// After the berries, which hide most of them.
		this.#stems.renderOrder = 1;
		for (const mesh of [this.#berries, this.#stems]) {
			// Their vertex shaders place them; three's bounds would not know where.
			mesh.frustumCulled = false;
			mesh.visible = false;
			this.group.add(mesh);
		}
	}

	/** Puts a bunch's geometry in place of the last one's. */
	show(grown: Grown): void {
		this.#showBerries(grown);
		this.#stems.visible = grown.stem !== undefined && grown.stem.indices.length > 0;
		if (grown.stem) this.#showStems(grown.stem);
		this.stemMaterial.uniforms.firstInternode.value = grown.berries.count;
	}

	set berriesVisible(shown: boolean) {
		this.#berries.visible = shown && this.#count > 0;
	}

	/** Sorts the berries nearest first, so that the depth test spares the pixels of those behind. */
	sort(camera: PerspectiveCamera): void {
		const eye = NEAREST_FIRST.setFromMatrixPosition(camera.matrixWorld);
		const s = this.#spheres;
		for (let i = 0; i < this.#count; i++) {
			this.#depths[i] = (s[4 * i] - eye.x) ** 2 + (s[4 * i + 1] - eye.y) ** 2 + (s[4 * i + 2] - eye.z) ** 2;
		}
		this.#order.sort((a, b) => this.#depths[a] - this.#depths[b]);
		const attribute = this.#berries.geometry.getAttribute("receiver");
		if (!(attribute instanceof InstancedBufferAttribute)) return;
		attribute.array.set(this.#order);
		attribute.needsUpdate = true;
	}

	dispose(): void {
		this.#berries.geometry.dispose();
		this.#stems.geometry.dispose();
		this.berryMaterial.dispose();
		this.stemMaterial.dispose();
	}

	#showBerries({ berries }: Grown): void {
		const room = this.#berries.geometry.getAttribute("receiver")?.count ?? 0;
		if (berries.count > room) {
			this.#berries.geometry.dispose();
			this.#berries.geometry = berryGeometry(Math.max(berries.count, Math.ceil(1.5 * room)));
		}
		if (berries.count !== this.#count) {
			this.#count = berries.count;
			this.#depths = new Float64Array(berries.count);
			this.#order = Array.from({ length: berries.count }, (_, i) => i);
		}
		this.#spheres = berries.spheres;
		this.#berries.geometry.instanceCount = berries.count;
	}

	#showStems(stem: StemMesh): void {
		const streams: [name: string, array: TypedArray, size: number][] = [
			["position", stem.positions, 3],
			["normal", stem.normals, 3],
			["uv", stem.uvs, 2],
			["internode", stem.internode, 1],
		];
		let { geometry } = this.#stems;
		const fits = (old: BufferAttribute | undefined, array: TypedArray) => (old?.array.length ?? -1) >= array.length;
		const roomy = streams.every(([name, array]) => fits(attributeOf(geometry, name), array));
		if (!roomy || !fits(geometry.index ?? undefined, stem.indices)) {
			geometry.dispose();
			geometry = new BufferGeometry();
			for (const [name, array, size] of streams) geometry.setAttribute(name, roomyAttribute(array, size));
			geometry.setIndex(roomyAttribute(stem.indices, 1));
			this.#stems.geometry = geometry;
		}
		for (const [name, array] of streams) fill(attributeOf(geometry, name), array);
		fill(geometry.index ?? undefined, stem.indices);
		geometry.setDrawRange(0, stem.indices.length);
	}
}

function attributeOf(geometry: BufferGeometry, name: string): BufferAttribute | undefined {
	const attribute = geometry.getAttribute(name);
	return attribute instanceof BufferAttribute ? attribute : undefined;
}

/** An attribute with half as much room again as its first content needs. */
function roomyAttribute(like: TypedArray, size: number): BufferAttribute {
	const length = Math.ceil((1.5 * like.length) / size) * size;
	const array = like instanceof Uint32Array ? new Uint32Array(length) : new Float32Array(length);
	return new BufferAttribute(array, size).setUsage(DynamicDrawUsage);
}

function fill(attribute: BufferAttribute | undefined, array: TypedArray): void {
	if (!attribute) return;
	attribute.array.set(array);
	attribute.clearUpdateRanges();
	attribute.addUpdateRange(0, array.length);
	attribute.needsUpdate = true;
}

function berryGeometry(room: number): InstancedBufferGeometry {
	const geometry = new InstancedBufferGeometry();
	const { positions, indices } = capMesh();
	geometry.setAttribute("position", new BufferAttribute(positions, 3));
	geometry.setIndex(new BufferAttribute(indices, 1));
	const receivers = new InstancedBufferAttribute(new Float32Array(room), 1).setUsage(DynamicDrawUsage);
	geometry.setAttribute("receiver", receivers);
	return geometry;
}
