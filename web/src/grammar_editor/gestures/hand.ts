/**
 * Reads position and pinch of the user's hand from the 21 landmarks of @mediapipe/hands, in shares of the camera's
 * picture: x to the right and y down as the camera sees them.
 */

export interface Landmark {
	readonly x: number;
	readonly y: number;
}

/** Position as shares of the picture, from the left and from the top as the person before the camera sees it. */
export interface Position {
	readonly x: number;
	readonly y: number;
}

export interface HandRead extends Position {
	/** Whether thumb and index finger have just closed. */
	readonly pinched: boolean;
}

/** Indices of landmarks. */
const [WRIST, THUMB_TIP, INDEX_KNUCKLE, INDEX_TIP, MIDDLE_KNUCKLE, LITTLE_KNUCKLE] = [0, 4, 5, 8, 9, 17];
const POINTS = 21;
/** Margin of the picture mapped beyond the ends of the axes: one at the picture's edge is not completely visible. */
const MARGIN = 0.18;
/**
 * Distance of the finger tips in lengths of the palm: a pinch begins below the first value, and ends above the second.
 */
const [TOGETHER, APART] = [0.28, 0.5];
/** Cut-off frequency of the filter for a resting hand, in hertz, and its increase with speed (Casiez et al. 2012). */
const [REST, HASTE] = [1, 4];

/** Reads one hand, picture by picture. */
export class HandReader {
	#held = false;
	#x: Smoothed | undefined;
	#y: Smoothed | undefined;

	/**
	 * Reads one picture; positions are smoothed over time.
	 * @param seconds time of the picture
	 * @returns undefined if the landmarks are not those of one hand
	 */
	read(landmarks: readonly Landmark[] | undefined, seconds: number): HandRead | undefined {
		const known = landmarks?.length === POINTS && landmarks.every(({ x, y }) => Number.isFinite(x + y));
		if (!landmarks || !known) {
			this.#held = false;
			this.#x = undefined;
			this.#y = undefined;
			return undefined;
		}
		const palm = [WRIST, INDEX_KNUCKLE, LITTLE_KNUCKLE].map((at) => landmarks[at]);
		const mean = (of: (point: Landmark) => number) => palm.reduce((sum, point) => sum + of(point), 0) / palm.length;
		this.#x = smooth(this.#x, withoutMargin(1 - mean(({ x }) => x)), seconds);
		this.#y = smooth(this.#y, withoutMargin(mean(({ y }) => y)), seconds);
		return { x: this.#x.at, y: this.#y.at, pinched: this.#pinches(landmarks) };
	}

	/**
	 * Returns whether thumb and index finger have come together since the last picture. They must part farther than they
	 * come together, so that noise does not pinch twice.
	 */
	#pinches(landmarks: readonly Landmark[]): boolean {
		const gap = distance(landmarks[THUMB_TIP], landmarks[INDEX_TIP]);
		const size = distance(landmarks[WRIST], landmarks[MIDDLE_KNUCKLE]);
		const before = this.#held;
		this.#held = gap < (before ? APART : TOGETHER) * size;
		return this.#held && !before;
	}
}

/** Returns the distance between two landmarks. */
const distance = (one: Landmark, other: Landmark) => Math.hypot(one.x - other.x, one.y - other.y);

/** Maps a share of the picture so that its margins count as 0 and 1. */
function withoutMargin(share: number): number {
	return Math.min(Math.max((share - MARGIN) / (1 - 2 * MARGIN), 0), 1);
}

/** State of the one euro filter for a noisy number: the faster the number changes, the less it is smoothed. */
interface Smoothed {
	readonly at: number;
	readonly speed: number;
	readonly seconds: number;
}

/** Returns the next state of the one euro filter (Casiez, Roussel and Vogel 2012). */
function smooth(before: Smoothed | undefined, value: number, seconds: number): Smoothed {
	if (!before || seconds <= before.seconds) return { at: before?.at ?? value, speed: before?.speed ?? 0, seconds };
	const elapsed = seconds - before.seconds;
	const speed = mix(before.speed, (value - before.at) / elapsed, shareIn(elapsed, REST));
	const share = shareIn(elapsed, REST + HASTE * Math.abs(speed));
	return { at: mix(before.at, value, share), speed, seconds };
}

/** Interpolates between two values. */
const mix = (one: number, other: number, share: number) => one + (other - one) * share;

/**
 * Returns the weight of a new value in a low-pass filter: 2π f t / (2π f t + 1).
 * @param seconds time t since the last value
 * @param hertz cut-off frequency f
 */
function shareIn(seconds: number, hertz: number): number {
	const turns = 2 * Math.PI * hertz * seconds;
	return turns / (turns + 1);
}
