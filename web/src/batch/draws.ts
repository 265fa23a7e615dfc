/**
 * Random draws of a series: the seed of each plant, and the values of varied parameters.
 *
 * Consecutive seeds, and equal seeds of two varieties, give related plants: a model may spread seeds evenly on purpose
 * (a bunch's length is a multiple of the golden ratio), which is right for the page and wrong for a sample. A series
 * therefore hashes.
 */
import { DEFAULT_SEED } from "../specimen/from_preset";
import { encodeQuery, textsOf } from "../specimen/link";
import type { ModelSchema } from "../specimen/model_schema";
import type { Specimen } from "../specimen/specimen";

export interface Draws {
	/** Whether the numbers are the seeds, and shares are the same in every series. */
	readonly literal: boolean;
	/** The seed of a plant by its number, 0 … 2³² − 1; different for each number. */
	seed(number: number): number;
	/** A uniform share for a plant and a quantity: from 0 to below 1. `quantity` names the drawn value: `vary age`. */
	share(quantity: string, number: number): number;
}

/**
 * Returns the settings that all plants of a series share, as one text: the query without its seed, and the texts of the
 * fragment, uncompressed.
 */
export function specificationOf<S extends Specimen>(schema: ModelSchema<S>, from: S): string {
	const common = { ...from, seed: DEFAULT_SEED };
	return JSON.stringify([schema.name, from.preset, encodeQuery(schema, common), ...textsOf(schema, common)]);
}

/** Returns draws that are independent between plants, quantities, varieties and settings: a hash of all four. */
export function independentDraws<S extends Specimen>(schema: ModelSchema<S>, from: S): Draws {
	const draw = hashFunction(specificationOf(schema, from));
	return {
		literal: false,
		seed: (number) => draw("seed", number),
		share: (quantity, number) => draw(quantity, number) / 2 ** 32,
	};
}

/**
 * Draws for paired comparisons: the number itself is the seed, and a quantity has the same share in every series,
 * for any variety and settings.
 */
export function literalDraws(): Draws {
	const draw = hashFunction("");
	return {
		literal: true,
		seed: (number) => number,
		share: (quantity, number) => draw(quantity, number) / 2 ** 32,
	};
}

/** Returns a function from a quantity and a number to 32 bits, one-to-one in the number. */
function hashFunction(specification: string): (quantity: string, number: number) => number {
	const keys = new Map<string, readonly [number, number]>();
	return (quantity, number) => {
		let key = keys.get(quantity);
		if (!key) {
			key = hashText([specification, quantity].join("\0"));
			keys.set(quantity, key);
		}
		return mixBits(mixBits(number ^ key[0]) ^ key[1]);
	};
}

/** Returns a hash of 64 bits of a text: FNV-1a (Fowler, Noll, Vo 1991) over its UTF-8, as two well-mixed words. */
function hashText(text: string): readonly [number, number] {
	let hash = 0xcbf29ce484222325n;
	for (const byte of new TextEncoder().encode(text)) hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
	return [mixBits(Number(hash >> 32n)), mixBits(Number(hash & 0xffffffffn))];
}

/** Makes every bit depend on every other, one-to-one (Appleby 2011, the finalizer of MurmurHash3). */
function mixBits(bits: number): number {
	let h = bits;
	h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
	h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
	return (h ^ (h >>> 16)) >>> 0;
}
