/**
 * Names of an OBJ's materials. OBJ has no vertex colours that every reader supports: parts of one material and one
 * variant are written in their mean colour.
 */
import { type Colour, meanColour } from "../plant/colour";
import type { Material } from "../plant/material";
import type { Shape } from "../plant/part";
import type { NamedMaterial } from "./mtl";

interface UsedMaterial {
	name: string;
	material: Material;
	/** Sum of the parts' mean colours, and the number of parts with colours. */
	sum: Colour;
	count: number;
}

export class ObjMaterials {
	/** By material, then by variant. */
	readonly #used = new Map<Material, Map<string, UsedMaterial>>();
	readonly #names = new Set<string>();

	/** Returns the name of a shape's material, and includes the shape's colours in the mean. */
	nameOf({ material, variant, mesh }: Shape): string {
		const variants = this.#used.get(material) ?? new Map<string, UsedMaterial>();
		this.#used.set(material, variants);
		const used = variants.get(variant ?? "") ?? this.#add(material, variant);
		variants.set(variant ?? "", used);
		if (variant !== undefined && mesh.colours) {
			meanColour(mesh.colours).forEach((value, channel) => {
				used.sum[channel] += value;
			});
			used.count++;
		}
		return used.name;
	}

	/** Returns all named materials, in the order of naming, with their mean colours. */
	all(): NamedMaterial[] {
		const used = [...this.#used.values()].flatMap((variants) => [...variants.values()]);
		return used.map(({ name, material, sum, count }) => {
			const colour = count > 0 ? (sum.map((value) => value / count) as Colour) : material.colour;
			return { name, material: { ...material, colour } };
		});
	}

	/** Names a material: by its own name and variant, numbered where that name is taken. */
	#add(material: Material, variant?: string): UsedMaterial {
		const wanted = `${material.name}${variant ? `_${variant}` : ""}`.replaceAll(/\s+/g, "_");
		let name = wanted;
		for (let number = 2; this.#names.has(name); number++) name = `${wanted}_${number}`;
		this.#names.add(name);
		return { name, material, sum: [0, 0, 0], count: 0 };
	}
}
