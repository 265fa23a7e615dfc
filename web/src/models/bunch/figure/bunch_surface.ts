import {
	BufferGeometry,
	Group,
	InstancedBufferGeometry,
	Mesh,
	type PerspectiveCamera,
	type ShaderMaterial,
	Vector3,
} from "three";
import { RecordTexture } from "../../../scene/record_texture";
import { fillInstances, fillStreams } from "../../../scene/streams";
import type { BerrySurfaces, Foliage, Grown, StemMesh } from "../grown";
import { openFlowers } from "../parts/flowers";
import { packVertices, surfacesOf, VERTICES_PER_ROW } from "./berry_skins";
import { DepthOrder } from "./depth_order";

const EYE = new Vector3();

/** The materials of a bunch's parts. */
export interface PartMaterials {
	berry: ShaderMaterial;
	stem: ShaderMaterial;
	flower: ShaderMaterial;
	foliage: ShaderMaterial;
}

/**
 * The meshes of a bunch: all berries as instances of one pattern whose vertices stand in a texture, all open flowers as
 * instances of one, all stems as one, all leaves as one. Buffers are kept from bunch to bunch.
 */
export class BunchSurface {
	readonly group = new Group();
	readonly #berries: Mesh<InstancedBufferGeometry, ShaderMaterial>;
	readonly #flowers: Mesh<InstancedBufferGeometry, ShaderMaterial>;
	readonly #stems: Mesh<BufferGeometry, ShaderMaterial>;
	readonly #foliage: Mesh<BufferGeometry, ShaderMaterial>;
	readonly #vertices = new RecordTexture(1, "words", VERTICES_PER_ROW);
	#spheres: Float32Array = new Float32Array(0);
	readonly #order = new DepthOrder();
	#berriesShown = true;

	constructor(readonly materials: PartMaterials) {
		this.#berries = this.#part("berries", new InstancedBufferGeometry(), materials.berry);
		this.#flowers = this.#part("flowers", new InstancedBufferGeometry(), materials.flower);
		this.#stems = this.#part("stems", new BufferGeometry(), materials.stem);
		this.#foliage = this.#part("foliage", new BufferGeometry(), materials.foliage);
		// After the berries, which hide most of them.
		this.#stems.renderOrder = 1;
	}

	/** Puts a bunch's geometry in place of the last one's. */
	show(grown: Grown): void {
		const surfaces = surfacesOf(grown);
		this.#spheres = grown.berries.spheres;
		this.#showBerries(surfaces, surfaces ? grown.berries.count : 0);
		this.#showFlowers(grown);
		this.#stems.visible = grown.stem !== undefined && grown.stem.indices.length > 0;
		if (grown.stem) this.#showStems(grown.stem);
		this.#foliage.visible = grown.foliage !== undefined && grown.foliage.indices.length > 0;
		if (grown.foliage) this.#showFoliage(grown.foliage);
		this.materials.stem.uniforms.firstInternode.value = grown.berries.count;
	}

	set berriesShown(shown: boolean) {
		this.#berriesShown = shown;
		this.#berries.visible = shown && this.#order.count > 0;
		this.#flowers.visible = shown && this.#flowers.geometry.instanceCount > 0;
	}

	/** Sorts the berries nearest first. */
	sort(camera: PerspectiveCamera): void {
		const order = this.#order.sorted(this.#spheres, EYE.setFromMatrixPosition(camera.matrixWorld));
		fillInstances(this.#berries.geometry, "receiver", order, 1);
	}

	dispose(): void {
		for (const part of [this.#berries, this.#flowers, this.#stems, this.#foliage]) {
			part.geometry.dispose();
			part.material.dispose();
		}
		this.#vertices.dispose();
	}

	#part<G extends BufferGeometry>(name: string, geometry: G, material: ShaderMaterial): Mesh<G, ShaderMaterial> {
		const part = new Mesh(geometry, material);
		part.name = name;
		// Their vertex shaders place them; three's bounds would not know where.
		part.frustumCulled = false;
		part.visible = false;
		this.group.add(part);
		return part;
	}

	#showBerries(surfaces: BerrySurfaces | undefined, count: number): void {
		this.#order.reset(count);
		const { geometry, material } = this.#berries;
		geometry.instanceCount = count;
		this.berriesShown = this.#berriesShown;
		if (!surfaces) return;
		this.#vertices.reserve(surfaces.pressed.length);
		packVertices(surfaces, this.#vertices.words);
		this.#vertices.changed();
		material.uniforms.vertexRecords.value = this.#vertices.texture;
		material.uniforms.patternVertices.value = surfaces.uvs.length / 2;
		fillStreams(geometry, [["uv", surfaces.uvs, 2]], surfaces.indices);
	}

	#showFlowers({ flower, berries }: Grown): void {
		const { geometry } = this.#flowers;
		const open = flower ? openFlowers(berries) : new Float32Array(0);
		geometry.instanceCount = open.length / 2;
		this.berriesShown = this.#berriesShown;
		if (!flower || open.length === 0) return;
		const { positions, normals, uvs, indices } = flower;
		fillStreams(
			geometry,
			[
				["position", positions, 3],
				["normal", normals, 3],
				["uv", uvs, 2],
			],
			indices,
		);
		fillInstances(geometry, "bloomed", open, 2);
	}

	#showStems({ positions, normals, uvs, internode, indices }: StemMesh): void {
		fillStreams(
			this.#stems.geometry,
			[
				["position", positions, 3],
				["normal", normals, 3],
				["uv", uvs, 2],
				["internode", internode, 1],
			],
			indices,
		);
	}

	#showFoliage({ positions, normals, uvs, indices, parts }: Foliage): void {
		const blade = new Float32Array(positions.length / 3);
		for (const { kind, firstVertex, vertexCount } of parts) {
			blade.fill(kind === "leaf" ? 1 : kind === "petiole" ? 0.5 : 0, firstVertex, firstVertex + vertexCount);
		}
		fillStreams(
			this.#foliage.geometry,
			[
				["position", positions, 3],
				["normal", normals, 3],
				["uv", uvs, 2],
				["blade", blade, 1],
			],
			indices,
		);
	}
}
