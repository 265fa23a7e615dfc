/** Seeded random numbers: the same seed gives the same numbers everywhere. */

/**
 * A generator of random numbers in [0, 1): mulberry32, by Tommy Ettinger.
 *
 * @param {number} seed an integer; its lowest 32 bits are used
 * @returns {() => number}
 */
function generator(seed) {
	let state = seed | 0;
	return () => {
		state = (state + 0x6d2b79f5) | 0;
		let mixed = Math.imul(state ^ (state >>> 15), state | 1);
		mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61);
		return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
	};
}

/**
 * Dice of one action of a run: an action draws the same numbers whichever actions came before it, so that a part of a run
 * can be repeated alone.
 *
 * @param {number} seed of the run
 * @param {number} number of the action
 */
export function diceOf(seed, number) {
	const next = generator(Math.imul(seed, 0x9e3779b1) ^ Math.imul(number, 0x85ebca6b));
	const between = (low, high) => low + (high - low) * next();
	return {
		next,
		/** A number in [low, high). */
		between,
		/** An integer in [0, count). */
		below: (count) => Math.floor(count * next()),
		/**
		 * An item of a list that is not empty.
		 * @template T
		 * @param {readonly T[]} list
		 * @returns {T}
		 */
		of: (list) => list[Math.floor(list.length * next())],
		/**
		 * A random item of a non-empty list, with a probability proportional to its weight.
		 * @template {{ weight: number }} T
		 * @param {readonly T[]} list
		 * @returns {T}
		 */
		weighted(list) {
			let left = next() * list.reduce((sum, { weight }) => sum + weight, 0);
			for (const item of list) {
				left -= item.weight;
				if (left < 0) return item;
			}
			return list[list.length - 1];
		},
	};
}

/** @typedef {ReturnType<typeof diceOf>} Dice */
