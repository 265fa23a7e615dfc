import { type MeshStandardMaterial, RepeatWrapping, type Texture } from "three";
import type { Material, Picture } from "../plant/material";
import type { LightUniforms } from "./light_shader";
import { pictureTexture } from "./picture_texture";
import { type CrownUniforms, standardMaterial } from "./standard_material";
import type { WindUniforms } from "./wind_shader";

/** Property of a three.js material for each kind of texture. */
const TEXTURE_SLOTS = { colour: "map", normal: "normalMap" } as const;
export type TextureKind = keyof typeof TEXTURE_SLOTS;
const KINDS = Object.keys(TEXTURE_SLOTS) as TextureKind[];

/**
 * Unused materials that stay cached: during a life, plants alternate between having leaves or particles and having
 * none.
 */
const MAX_UNUSED = 24;

interface CachedMaterial {
	made: MeshStandardMaterial;
	lastUsed: number;
	/** Pictures that the textures show. */
	shows: Partial<Record<TextureKind, Picture>>;
}

/**
 * Cache of three.js materials across plants. Disposing of the last material of a kind also disposes of its program,
 * and compiling that again takes many frames.
 */
export class MaterialCache {
	readonly #light: LightUniforms;
	readonly #wind: WindUniforms | undefined;
	/** Materials by a key of all properties that distinguish them. */
	readonly #cached = new Map<string, CachedMaterial>();
	/**
	 * Textured materials of the current plant, in order; their index is part of the key, because pictures may change.
	 */
	readonly #textured = new Map<Material, number>();
	#plant = 0;

	readonly #crown: CrownUniforms | undefined;

	/**
	 * @param wind wind that moves the parts; without it they do not move
	 * @param crown crown that bends the normals of sheets outwards
	 */
	constructor(light: LightUniforms, wind?: WindUniforms, crown?: CrownUniforms) {
		this.#crown = crown;
		this.#light = light;
		this.#wind = wind;
	}

	/** Begins another plant. Of the materials that the last two plants did not use, only some stay cached. */
	change(): void {
		this.#plant++;
		this.#textured.clear();
		const unused = [...this.#cached].filter(([, { lastUsed }]) => lastUsed < this.#plant - 2);
		unused.sort(([, one], [, other]) => other.lastUsed - one.lastUsed);
		for (const [key, cached] of unused.slice(MAX_UNUSED)) {
			disposeOf(cached);
			this.#cached.delete(key);
		}
	}

	/**
	 * Returns the three.js material for a material. Geometries that use it have an attribute `sky`, the visible share
	 * of the sky, for vertices or instances.
	 * @param coloured whether vertices have colours
	 * @param thin whether vertices have the width of a tube
	 */
	materialOf(material: Material, coloured: boolean, thin = false): MeshStandardMaterial {
		const { textures, ...plain } = material;
		if (textures && !this.#textured.has(material)) this.#textured.set(material, this.#textured.size);
		// If a picture is shown, its mean colour does not matter.
		const keyed = textures?.colour ? { ...plain, colour: undefined } : plain;
		const kinds = textures && KINDS.filter((kind) => textures[kind]);
		const key = JSON.stringify([keyed, coloured, thin, kinds, textures?.repeats, this.#textured.get(material)]);
		const cached = this.#cached.get(key) ?? this.#make(material, coloured, thin);
		cached.lastUsed = this.#plant;
		this.#cached.set(key, cached);
		for (const kind of kinds ?? []) showPicture(cached, kind, textures?.[kind] as Picture);
		return cached.made;
	}

	/** Replaces a picture on a material that already shows one. */
	setPicture(made: MeshStandardMaterial, kind: TextureKind, picture: Picture): void {
		for (const cached of this.#cached.values())
			if (cached.made === made && cached.shows[kind]) showPicture(cached, kind, picture);
	}

	/** Releases the graphics memory of all materials. */
	dispose(): void {
		for (const cached of this.#cached.values()) disposeOf(cached);
		this.#cached.clear();
	}

	/** Creates the three.js material of a material, with its textures. */
	#make(material: Material, coloured: boolean, thin: boolean): CachedMaterial {
		const { repeats, ...shows } = material.textures ?? {};
		const maps = Object.fromEntries(
			KINDS.flatMap((kind) => (shows[kind] ? [[kind, pictureTexture(shows[kind], kind === "colour", repeats)]] : [])),
		);
		return {
			made: standardMaterial(material, {
				light: this.#light,
				coloured,
				thin,
				sky: true,
				maps,
				...(this.#wind && !material.still ? { wind: this.#wind } : {}),
				...(this.#crown ? { crown: this.#crown } : {}),
			}),
			lastUsed: 0,
			shows,
		};
	}
}

/**
 * Replaces the texture of a kind by one of another picture; does nothing if the material shows that picture already.
 */
function showPicture({ made, shows }: CachedMaterial, kind: TextureKind, picture: Picture): void {
	if (shows[kind] === picture) return;
	(made[TEXTURE_SLOTS[kind]] as Texture).dispose();
	made[TEXTURE_SLOTS[kind]] = pictureTexture(
		picture,
		kind === "colour",
		(made[TEXTURE_SLOTS[kind]] as Texture).wrapS === RepeatWrapping,
	);
	shows[kind] = picture;
}

/** Frees a material and its textures on the graphics card. */
function disposeOf({ made }: CachedMaterial): void {
	for (const kind of KINDS) made[TEXTURE_SLOTS[kind]]?.dispose();
	made.dispose();
}
