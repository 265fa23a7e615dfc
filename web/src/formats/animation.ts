/** Elements of a glTF animation: nodes that are visible for a time, and nodes that sway without end. */
import { PERIOD } from "../plant/sway";

type Json = Record<string, unknown>;

/** The time in which a node is visible, seconds; without an end it is visible until `rest` ends. */
export type Moment = { from: number; until: number } | { from: number; rest: number };

/** Returns key times, the scale at each (three numbers), and the scale for readers that play no animation. */
export function keysOf(moment: Moment): { times: number[]; scales: number[]; scale: 0 | 1 } {
	const ends = "until" in moment;
	const { from } = moment;
	const last = ends ? moment.until : moment.rest;
	const [times, seen] =
		from > 0
			? [
					[0, from, last],
					[0, 1, ends ? 0 : 1],
				]
			: [
					[0, last],
					[1, ends ? 0 : 1],
				];
	return { times, scales: seen.flatMap((value) => [value, value, value]), scale: ends ? 0 : 1 };
}

/** Keys of one period of a swing: weights are linear between them. */
const KEYS = 24;

/**
 * Returns the key times of a whole swing, and at each the weights of its sine and of its cosine; the last equal the
 * first.
 */
export function swingKeys(): { times: number[]; weights: number[] } {
	const steps = Array.from({ length: KEYS + 1 }, (_, i) => i);
	const angle = (i: number) => (2 * Math.PI * (i % KEYS)) / KEYS;
	return {
		times: steps.map((i) => (PERIOD * i) / KEYS),
		weights: steps.flatMap((i) => [Math.sin(angle(i)), Math.cos(angle(i))]),
	};
}

/** Collects channels; all begin at the same time. */
export class AnimationWriter {
	readonly #channels: Json[] = [];
	readonly #samplers: Json[] = [];

	/**
	 * Animates a property of a node in steps.
	 * @param input accessor of the key times
	 * @param output accessor of the values at them
	 */
	step(node: number, path: string, input: number, output: number): void {
		this.#add(node, path, { input, output, interpolation: "STEP" });
	}

	/** Animates a property of a node linearly; accessors as in `step`. */
	run(node: number, path: string, input: number, output: number): void {
		this.#add(node, path, { input, output, interpolation: "LINEAR" });
	}

	/**
	 * Adds a channel with a sampler of its own.
	 * @param path the animated property of the node: "scale", "weights"
	 */
	#add(node: number, path: string, made: Json): void {
		const sampler = this.#samplers.push(made) - 1;
		this.#channels.push({ sampler, target: { node, path } });
	}

	/** Returns the animation as in documents; an empty list where nothing moves. */
	written(name: string): Json[] {
		return this.#channels.length > 0 ? [{ name, channels: this.#channels, samplers: this.#samplers }] : [];
	}
}
