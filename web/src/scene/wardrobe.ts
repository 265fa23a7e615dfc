import type { MeshStandardMaterial } from "three";
import type { Material, Picture } from "../plant/material";
import { grainChunk } from "./grain";
import type { LightUniforms } from "./light_shader";
import { standardMaterial } from "./standard_material";

/**
 * Materials as three's, kept from one plant to the next: whoever throws the last one of a kind away throws its program
 * away too, and to build that anew takes many frames.
 */
export class Wardrobe {
	readonly #light: LightUniforms;
	/** By all that tells two apart; with the plant that last wore them. */
	readonly #kept = new Map<string, { made: MeshStandardMaterial; worn: number }>();
	readonly #pictures = new WeakMap<Picture, number>();
	#seen = 0;
	#plant = 0;

	constructor(light: LightUniforms) {
		this.#light = light;
	}

	/** Another plant is to be dressed: what the last two have not worn goes. */
	change(): void {
		this.#plant++;
		for (const [key, { made, worn }] of this.#kept) {
			if (worn >= this.#plant - 2) continue;
			made.map?.dispose();
			made.dispose();
			this.#kept.delete(key);
		}
	}

	/**
	 * @param coloured whether vertices have colours
	 * @param sky whether vertices or instances know how much of the sky they see
	 */
	materialOf(material: Material, coloured: boolean, sky: boolean): MeshStandardMaterial {
		const { textures, ...plain } = material;
		const key = JSON.stringify([plain, this.#numberOf(textures?.colour), coloured, sky]);
		const kept = this.#kept.get(key) ?? { made: this.#make(material, coloured, sky), worn: 0 };
		kept.worn = this.#plant;
		this.#kept.set(key, kept);
		return kept.made;
	}

	dispose(): void {
		for (const { made } of this.#kept.values()) {
			made.map?.dispose();
			made.dispose();
		}
		this.#kept.clear();
	}

	/** Pictures are told apart as objects: to read them would take longer than to draw with them. */
	#numberOf(picture: Picture | undefined): number {
		if (!picture) return 0;
		const number = this.#pictures.get(picture) ?? ++this.#seen;
		this.#pictures.set(picture, number);
		return number;
	}

	#make(material: Material, coloured: boolean, sky: boolean): MeshStandardMaterial {
		const detail = material.grain === undefined ? undefined : grainChunk(material.grain);
		return standardMaterial(material, { light: this.#light, coloured, sky, detail });
	}
}
