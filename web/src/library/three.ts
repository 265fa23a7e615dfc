/**
 * Plants as objects of three.js, without a way round by a file.
 *
 * @packageDocumentation
 */
import { Group, InstancedBufferAttribute, InstancedMesh, type MeshStandardMaterial } from "three";
import { writtenColours } from "../formats/vertex_colours";
import type { Material } from "../plant/material";
import { everyPart, type Part, type PartMesh, type Shape } from "../plant/part";
import { repeatedColour, shaded } from "../plant/shade";
import { PartMeshes } from "../render/part_meshes";
import { pictureTexture } from "../render/picture_texture";
import { plainMaterial } from "../render/standard_material";
import { partsOf } from "./files";
import type { Grown } from "./grow";

/**
 * A plant as a group of three's meshes, for games and scenes that have a renderer of their own: the parts, names and
 * physically based materials of the detailed GLB, with the shade in their vertex colours. Metres, +Y up; a bunch hangs
 * from the origin, trees stand on it. Repeated parts, such as a tree's leaves, are an `InstancedMesh`, each instance in
 * its own shade.
 *
 * Geometries, materials and textures belong to the group: dispose of them when you remove it.
 * @param grown - a plant with meshes
 * @returns the group; `userData` has its link and its fingerprint
 * @throws `SpecimenError` where the plant was grown without meshes
 *
 * @example
 * ```js
 * scene.add(await toObject3D(await grow("riesling")));
 * ```
 */
export async function toObject3D(grown: Grown): Promise<Group> {
	const shade = new Shade();
	const parts = (await partsOf(grown)).map((part) => shade.on(part));
	const shapes = [...everyPart(parts)].flatMap(({ shape }) => shape ?? []);
	const group = new Group();
	group.name = `${grown.specimen.model} ${grown.specimen.preset}`;
	group.userData = { link: grown.link, fingerprint: grown.fingerprint };
	for (const [index, object] of new PartMeshes(parts, new MaterialCache()).objects.entries()) {
		object.geometry.deleteAttribute("sky");
		object.frustumCulled = true;
		if (object instanceof InstancedMesh) object.instanceColor = tintsOf(shapes[index]);
		group.add(object);
	}
	return group;
}

/** Parts with their visible share of the sky in their colours, as in files; meshes stay shared. */
class Shade {
	readonly #known = new Map<PartMesh, PartMesh>();

	/** Returns a part, and its children, with the shade in their colours. */
	on(part: Part): Part {
		const { shape, children } = part;
		return {
			...part,
			...(shape ? { shape: { ...shape, mesh: this.#mesh(shape) } } : {}),
			...(children ? { children: children.map((child) => this.on(child)) } : {}),
		};
	}

	/** Returns a mesh with the shade in its colours, made once. */
	#mesh({ mesh, material }: Shape): PartMesh {
		const known = this.#known.get(mesh);
		if (known) return known;
		const colours = writtenColours(mesh, material);
		const shaded = colours ? { ...mesh, colours } : mesh;
		this.#known.set(mesh, shaded);
		return shaded;
	}
}

/** Factors on the colours of instances, where instances see different shares of the sky; linear. */
function tintsOf({ mesh, material, instances }: Shape): InstancedBufferAttribute | null {
	if (!instances?.sky || mesh.sky) return null;
	const open = repeatedColour([1, 1, 1], instances.sky.length);
	return new InstancedBufferAttribute(shaded(open, instances.sky, material.colour), 3);
}

/** Materials of three.js, each made once with vertex colours and once without. */
class MaterialCache {
	readonly #made = {
		coloured: new Map<Material, MeshStandardMaterial>(),
		plain: new Map<Material, MeshStandardMaterial>(),
	};

	/** Returns the three.js material of a material, made once with vertex colours and once without. */
	materialOf(material: Material, coloured: boolean): MeshStandardMaterial {
		const cache = this.#made[coloured ? "coloured" : "plain"];
		const made = cache.get(material) ?? makeMaterial(material, coloured);
		cache.set(material, made);
		return made;
	}
}

/** Makes a three.js material with its textures. */
function makeMaterial(material: Material, coloured: boolean): MeshStandardMaterial {
	const { colour, normal, repeats } = material.textures ?? {};
	const maps = {
		...(colour ? { colour: pictureTexture(colour, true, repeats) } : {}),
		...(normal ? { normal: pictureTexture(normal, false, repeats) } : {}),
	};
	return plainMaterial(material, { coloured, maps });
}
