import {
	BufferGeometry,
	Group,
	InstancedBufferGeometry,
	type Material,
	Mesh,
	type MeshStandardMaterial,
	type PerspectiveCamera,
	type ShaderMaterial,
	Vector3,
} from "three";
import type { Veins } from "../../../plant/leaf";
import { RecordTexture } from "../../../render/record_texture";
import { setPicture, setSheet } from "../../../render/standard_material";
import { fillStreams } from "../../../render/streams";
import { type BerrySurfaces, type BunchPlant, FOLIAGE_KINDS, type Foliage } from "../bunch_plant";
import type { BerryTint } from "../parts/berry_tint";
import { autumnOf, foliageColours } from "../parts/foliage_colour";
import { foliageMaterials } from "../parts/materials";
import type { Look } from "../specimen";
import { BerryInstances } from "./berry_instances";
import { packVertices, skiesOf, surfacesOf, VERTICES_PER_ROW } from "./berry_skins";
import { DepthOrder } from "./depth_order";
import { Flowers } from "./flowers";
import { stemStreams } from "./stem_streams";
import { triangleOrder } from "./triangle_order";

const EYE = new Vector3();

/** The materials of a bunch's parts. */
export interface PartMaterials {
	berry: ShaderMaterial;
	stem: MeshStandardMaterial;
	flower: MeshStandardMaterial;
	foliage: Record<(typeof FOLIAGE_KINDS)[number], MeshStandardMaterial>;
}

/**
 * Meshes of a bunch: all berries as instances of one pattern whose vertices are in a texture, all open flowers as
 * instances, all stems as one mesh, all leaves as one. Buffers are reused from bunch to bunch.
 */
export class BunchSurface {
	readonly group = new Group();
	readonly #berries: Mesh<InstancedBufferGeometry, ShaderMaterial>;
	readonly #stems: Mesh<BufferGeometry, MeshStandardMaterial>;
	readonly #foliage: Mesh<BufferGeometry, MeshStandardMaterial[]>;
	readonly #flowers: Flowers;
	readonly #vertices = new RecordTexture(1, "words", VERTICES_PER_ROW);
	readonly #instances = new BerryInstances();
	readonly #order = new DepthOrder();
	#shown: { grown: BunchPlant; look: Look } | undefined;
	#bare = false;
	#leavesDrawnFor: { veins: Veins | undefined; autumn: number } | undefined;

	/** @param materials one for each kind of part; foliage has several */
	constructor(readonly materials: PartMaterials) {
		const { berry, stem, flower, foliage } = materials;
		this.#berries = this.#addPart("berries", new InstancedBufferGeometry(), berry);
		this.#stems = this.#addPart("stems", new BufferGeometry(), stem);
		this.#foliage = this.#addPart(
			"foliage",
			new BufferGeometry(),
			FOLIAGE_KINDS.map((kind) => foliage[kind]),
		);
		this.#flowers = new Flowers(this.group, flower);
		// Drawn after the berries, which hide most of them.
		this.#stems.renderOrder = 1;
	}

	/** Replaces the geometry by another bunch's. */
	show(grown: BunchPlant, look: Look, tint: (berry: number) => BerryTint): void {
		this.#shown = { grown, look };
		const surfaces = surfacesOf(grown);
		const skies = surfaces && skiesOf(surfaces, grown.berries.count);
		if (surfaces && skies) this.#showBerries(surfaces, grown, tint, skies);
		this.#order.reset(surfaces ? grown.berries.spheres : new Float32Array(0));
		this.#flowers.show(grown, skies);
		this.#foliage.visible = grown.foliage !== undefined && grown.foliage.indices.length > 0;
		if (grown.foliage) this.#showFoliage(grown.foliage, autumnOf(grown.berries));
		this.#showStems();
		this.#setVisible();
	}

	/** Whether the stems are shown without berries, with withered ones marked. */
	set bare(bare: boolean) {
		if (bare === this.#bare) return;
		this.#bare = bare;
		this.#showStems();
		this.#setVisible();
	}

	/** Sorts the berries by their distance from the camera, nearest first. */
	sort(camera: PerspectiveCamera): void {
		if (this.#order.sort(EYE.setFromMatrixPosition(camera.matrixWorld)))
			this.#instances.order(this.#berries.geometry, this.#order.indices);
	}

	/** Releases the graphics memory. */
	dispose(): void {
		for (const part of [this.#berries, this.#stems, this.#foliage]) part.geometry.dispose();
		this.#flowers.dispose();
		const { berry, stem, flower, foliage } = this.materials;
		for (const material of [berry, stem, flower, ...Object.values(foliage)]) material.dispose();
		foliage.leaf.map?.dispose();
		this.#vertices.dispose();
	}

	/** Creates the mesh of a kind of parts and adds it to the group, invisible at first. */
	#addPart<G extends BufferGeometry, M extends Material | Material[]>(
		name: string,
		geometry: G,
		material: M,
	): Mesh<G, M> {
		const part = new Mesh(geometry, material);
		part.name = name;
		// Buffers are larger than their content, and the berries' shader places them: three's bounds would be wrong.
		part.frustumCulled = false;
		part.visible = false;
		this.group.add(part);
		return part;
	}

	/** Hides berries and flowers where only stems are shown. */
	#setVisible(): void {
		this.#berries.visible = !this.#bare && this.#order.indices.length > 0;
		this.#flowers.visible = !this.#bare;
	}

	/**
	 * Uploads the berries: vertices into a texture, which the shader reads for each instance, and one pattern of
	 * triangles for all.
	 * @param skies share of the visible sky of each berry
	 */
	#showBerries(
		surfaces: BerrySurfaces,
		{ berries }: BunchPlant,
		tint: (berry: number) => BerryTint,
		skies: Float32Array,
	): void {
		const { geometry, material } = this.#berries;
		this.#vertices.reserve(surfaces.pressed.length);
		const reaches = packVertices(surfaces, berries, this.#vertices.uint32);
		this.#vertices.changed();
		material.uniforms.vertexRecords.value = this.#vertices.texture;
		material.uniforms.patternVertices.value = surfaces.uvs.length / 2;
		fillStreams(geometry, [["uv", surfaces.uvs, 2]], triangleOrder(surfaces.indices));
		this.#instances.show(berries, tint, reaches, skies);
	}

	/** Updates the mesh of the stems from the shown bunch. */
	#showStems(): void {
		const { grown, look } = this.#shown ?? {};
		const stem = grown?.stem;
		this.#stems.visible = stem !== undefined && stem.indices.length > 0;
		if (grown && stem && look)
			fillStreams(this.#stems.geometry, stemStreams(grown, stem, look.stem, this.#bare), stem.indices);
	}

	/** Updates the leaves' textures, only when they change, not with every step of a drag. */
	#updateLeafTextures(veins: Veins | undefined, autumn: number): void {
		if (this.#leavesDrawnFor?.veins === veins && this.#leavesDrawnFor?.autumn === autumn) return;
		this.#leavesDrawnFor = { veins, autumn };
		const { leaf } = foliageMaterials(autumn, veins);
		setSheet(this.materials.foliage.leaf, leaf);
		setPicture(this.materials.foliage.leaf, leaf);
	}

	/** Updates the geometry and materials of leaves and canes. */
	#showFoliage(foliage: Foliage, autumn: number): void {
		const { positions, normals, uvs, indices, parts } = foliage;
		const { geometry } = this.#foliage;
		this.#updateLeafTextures(foliage.veins, autumn);
		fillStreams(
			geometry,
			[
				["position", positions, 3],
				["normal", normals, 3],
				["uv", uvs, 2],
				["color", foliageColours(foliage, autumn), 3],
				["sky", foliage.sky ?? new Uint8Array(positions.length / 3).fill(255), 1],
			],
			indices,
		);
		geometry.clearGroups();
		for (const { kind, firstIndex, indexCount } of parts) {
			geometry.addGroup(firstIndex, indexCount, FOLIAGE_KINDS.indexOf(kind));
		}
	}
}
