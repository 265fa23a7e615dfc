/** Access to the traits of berries by name. */
import { type Berries, TRAITS, type Trait } from "./bunch_plant";

/** Index of each trait among those of a berry. */
const TRAIT_INDEX = Object.fromEntries(TRAITS.map((trait, at) => [trait, at])) as Record<Trait, number>;

/** Returns a trait of berry `i`, with float32 precision. */
export function traitOf({ traits }: Pick<Berries, "traits">, i: number, trait: Trait): number {
	return traits[TRAITS.length * i + TRAIT_INDEX[trait]];
}

/** Returns half width and half length of berry `i`, metres. */
export function halvesOf(berries: Berries, i: number): [halfWidth: number, halfLength: number] {
	return [0.5 * traitOf(berries, i, "width"), 0.5 * traitOf(berries, i, "length")];
}

/** Returns the mean of a trait over all berries; `otherwise` if there are none. */
export function meanOf(berries: Berries, trait: Trait, otherwise: number): number {
	let sum = 0;
	for (let i = 0; i < berries.count; i++) sum += traitOf(berries, i, trait);
	return berries.count > 0 ? sum / berries.count : otherwise;
}
