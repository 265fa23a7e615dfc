/** Splits a bunch into parts: axes with their pedicels, berries, cane, leaves and petioles. */

import { linear, meanColour } from "../../../plant/colour";
import type { Material } from "../../../plant/material";
import { cut, type Part, type Shape } from "../../../plant/part";
import type { BunchPlant, Foliage, StemMesh } from "../bunch_plant";
import { text } from "../messages.generated";
import type { Look } from "../specimen";
import { naturalBerries, sharedBerries } from "./berries";
import { autumnOf, foliageColours } from "./foliage_colour";
import { foliageMaterials, stemMaterial } from "./materials";
import { foliageNames, stemName } from "./names";
import type { BunchDress } from "./skin";
import { stemColours } from "./stem_colour";

/**
 * Yields the parts of a bunch.
 * @param grown not modified
 * @throws Error with a message for users if `grown` has no meshes
 */
export function* bunchParts(grown: BunchPlant, dress: BunchDress): Generator<Part> {
	const { stem, berry, surfaces, berries, foliage } = grown;
	if (!stem || (berries.count > 0 && !berry && !surfaces)) {
		throw new Error(text("no_meshes"));
	}
	yield* stemsOf(grown, stem, dress.look);
	if (berries.count > 0 && surfaces) yield naturalBerries(grown, surfaces, dress);
	else if (berries.count > 0 && berry) yield sharedBerries(grown, berry, dress);
	if (foliage) yield* foliageOf(grown, foliage);
}

/** Yields the rachis and each axis with its pedicels as parts with vertex colours. */
function* stemsOf(grown: BunchPlant, stem: StemMesh, { stem: hex }: Look): Generator<Part> {
	const colours = stemColours(grown, stem, hex);
	const material = stemMaterial(colours.length > 0 ? meanColour(colours) : linear(hex));
	for (const part of stem.parts) {
		if (part.indexCount > 0)
			yield { name: stemName(part.axis), shape: { mesh: cut({ ...stem, colours }, part), material } };
	}
}

/** Yields a part per leaf, petiole and cane, in autumn's colours as far as the berries have dried. */
function* foliageOf({ berries }: BunchPlant, foliage: Foliage): Generator<Part> {
	const autumn = autumnOf(berries);
	const colours = foliageColours(foliage, autumn);
	const materials = foliageMaterials(autumn, foliage.veins);
	const names = foliageNames(foliage.parts);
	for (const [index, part] of foliage.parts.entries()) {
		if (part.indexCount > 0)
			yield {
				name: names[index],
				shape: {
					mesh: cut({ ...foliage, colours }, part),
					material: materials[part.kind],
					...variantOf(materials[part.kind]),
				},
			};
	}
}

/**
 * Returns that a shape has a variant without vertex colours; shapes with a colour texture need none, because their
 * vertex colours only darken it.
 */
function variantOf({ textures }: Material): Pick<Shape, "variant"> {
	return textures?.colour ? {} : { variant: "" };
}
