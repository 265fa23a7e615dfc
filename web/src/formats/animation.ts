/** What a glTF animation is made of: things that are seen for a while, and what sways for ever. */
import { BEAT } from "../plant/sway";

type Json = Record<string, unknown>;

/** When something is to be seen, seconds; what has no end is seen until the rest ends. */
export type Moment = { from: number; until: number } | { from: number; rest: number };

/** Times, the scale at each (three numbers), and the scale of who plays nothing. */
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

/** Keys of a swing from its beginning to where it begins anew: between them weights run straight. */
const KEYS = 24;

/** Times of a whole swing, and at each the weights of its sine and of its cosine; the last are the first. */
export function swingKeys(): { times: number[]; weights: number[] } {
	const steps = Array.from({ length: KEYS + 1 }, (_, i) => i);
	const angle = (i: number) => (2 * Math.PI * (i % KEYS)) / KEYS;
	return {
		times: steps.map((i) => (BEAT * i) / KEYS),
		weights: steps.flatMap((i) => [Math.sin(angle(i)), Math.cos(angle(i))]),
	};
}

/** Collects channels; all begin together. */
export class Animation {
	readonly #channels: Json[] = [];
	readonly #samplers: Json[] = [];

	/** Has a property of a node go from value to value without between; both are accessors. */
	step(node: number, path: string, input: number, output: number): void {
		this.#add(node, path, { input, output, interpolation: "STEP" });
	}

	/** The same by straight lines between. */
	run(node: number, path: string, input: number, output: number): void {
		this.#add(node, path, { input, output, interpolation: "LINEAR" });
	}

	#add(node: number, path: string, made: Json): void {
		const sampler = this.#samplers.push(made) - 1;
		this.#channels.push({ sampler, target: { node, path } });
	}

	/** As documents have it; none where nothing moves. */
	written(name: string): Json[] {
		return this.#channels.length > 0 ? [{ name, channels: this.#channels, samplers: this.#samplers }] : [];
	}
}
