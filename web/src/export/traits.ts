/** The traits of one berry by name. */
import { type Berries, TRAITS, type Trait } from "../models/bunch/grown";

const PLACE = Object.fromEntries(TRAITS.map((trait, index) => [trait, index])) as Record<Trait, number>;

/** What berry `index` is, as float32 numbers. */
export function traitOf({ traits }: Berries, index: number, trait: Trait): number {
	return traits[TRAITS.length * index + PLACE[trait]];
}
