import { type MeshStandardMaterial, RepeatWrapping, type Texture } from "three";
import type { Material, Picture } from "../plant/material";
import type { LightUniforms } from "./light_shader";
import { pictureTexture } from "./picture_texture";
import { standardMaterial } from "./standard_material";
import type { WindUniforms } from "./wind";

/** The textures that are drawn, and what of a material of three's shows each. */
const DRAWN = { colour: "map", normal: "normalMap" } as const;
export type Drawn = keyof typeof DRAWN;
const KINDS = Object.keys(DRAWN) as Drawn[];

/** A life runs from plants with leaves to some without, from some with particles on their way to some without: and back. */
const MOST_UNWORN = 24;

interface Kept {
	made: MeshStandardMaterial;
	worn: number;
	/** What its textures show. */
	shows: Partial<Record<Drawn, Picture>>;
}

/**
 * Materials as three's, kept from one plant to the next: whoever throws the last one of a kind away throws its program
 * away too, and to build that anew takes many frames.
 */
export class MaterialCache {
	readonly #light: LightUniforms;
	readonly #wind: WindUniforms | undefined;
	/** By all that tells two apart; with the plant that last wore them. */
	readonly #kept = new Map<string, Kept>();
	/** The textured materials of the plant that is being dressed, in order: pictures may change, their place stays. */
	readonly #textured = new Map<Material, number>();
	#plant = 0;

	/** @param wind what moves all that is worn; where absent it stands still */
	constructor(light: LightUniforms, wind?: WindUniforms) {
		this.#light = light;
		this.#wind = wind;
	}

	/** Another plant is to be dressed, the last one is off the stage: of what the last two have not worn only so much stays. */
	change(): void {
		this.#plant++;
		this.#textured.clear();
		const unworn = [...this.#kept].filter(([, { worn }]) => worn < this.#plant - 2);
		unworn.sort(([, one], [, other]) => other.worn - one.worn);
		for (const [key, kept] of unworn.slice(MOST_UNWORN)) {
			thrownAway(kept);
			this.#kept.delete(key);
		}
	}

	/**
	 * What wears it says how much of the sky it sees (`sky`), vertices or instances.
	 * @param coloured whether vertices have colours
	 */
	materialOf(material: Material, coloured: boolean): MeshStandardMaterial {
		const { textures, ...plain } = material;
		if (textures && !this.#textured.has(material)) this.#textured.set(material, this.#textured.size);
		// A picture's mean does not matter where the picture is shown.
		const told = textures?.colour ? { ...plain, colour: undefined } : plain;
		const laid = textures && KINDS.filter((kind) => textures[kind]);
		const key = JSON.stringify([told, coloured, laid, textures?.repeats, this.#textured.get(material)]);
		const kept = this.#kept.get(key) ?? this.#make(material, coloured);
		kept.worn = this.#plant;
		this.#kept.set(key, kept);
		for (const kind of laid ?? []) showPicture(kept, kind, textures?.[kind] as Picture);
		return kept.made;
	}

	/** Another picture on a material that wears one already. */
	setPicture(made: MeshStandardMaterial, kind: Drawn, picture: Picture): void {
		for (const kept of this.#kept.values())
			if (kept.made === made && kept.shows[kind]) showPicture(kept, kind, picture);
	}

	dispose(): void {
		for (const kept of this.#kept.values()) thrownAway(kept);
		this.#kept.clear();
	}

	#make(material: Material, coloured: boolean): Kept {
		const { repeats, ...shows } = material.textures ?? {};
		const maps = Object.fromEntries(
			KINDS.flatMap((kind) => (shows[kind] ? [[kind, pictureTexture(shows[kind], kind === "colour", repeats)]] : [])),
		);
		return {
			made: standardMaterial(material, {
				light: this.#light,
				coloured,
				sky: true,
				maps,
				...(this.#wind && !material.still ? { wind: this.#wind } : {}),
			}),
			worn: 0,
			shows,
		};
	}
}

/** Another picture in place of the one that it shows. */
function showPicture({ made, shows }: Kept, kind: Drawn, picture: Picture): void {
	if (shows[kind] === picture) return;
	(made[DRAWN[kind]] as Texture).dispose();
	made[DRAWN[kind]] = pictureTexture(
		picture,
		kind === "colour",
		(made[DRAWN[kind]] as Texture).wrapS === RepeatWrapping,
	);
	shows[kind] = picture;
}

function thrownAway({ made }: Kept): void {
	for (const kind of KINDS) made[DRAWN[kind]]?.dispose();
	made.dispose();
}
