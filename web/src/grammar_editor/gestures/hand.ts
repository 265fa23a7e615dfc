/**
 * Reads position and pinch of the user's hand from the 21 landmarks of @mediapipe/hands, in shares of the camera's picture: x
 * to the right and y down as the camera sees them.
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
		this.#x = smoothed(this.#x, within(1 - mean(({ x }) => x)), seconds);
		this.#y = smoothed(this.#y, within(mean(({ y }) => y)), seconds);
		return { x: this.#x.at, y: this.#y.at, pinched: this.#pinches(landmarks) };
	}

	#pinches(landmarks: readonly Landmark[]): boolean {
		const apart = between(landmarks[THUMB_TIP], landmarks[INDEX_TIP]);
		const size = between(landmarks[WRIST], landmarks[MIDDLE_KNUCKLE]);
		const before = this.#held;
		this.#held = apart < (before ? APART : TOGETHER) * size;
		return this.#held && !before;
	}
}

const between = (one: Landmark, other: Landmark) => Math.hypot(one.x - other.x, one.y - other.y);

function within(share: number): number {
	return Math.min(Math.max((share - MARGIN) / (1 - 2 * MARGIN), 0), 1);
}

/** State of the one euro filter for a noisy number: the faster the number changes, the less it is smoothed. */
interface Smoothed {
	readonly at: number;
	readonly speed: number;
	readonly seconds: number;
}

function smoothed(before: Smoothed | undefined, at: number, seconds: number): Smoothed {
	if (!before || seconds <= before.seconds) return { at: before?.at ?? at, speed: before?.speed ?? 0, seconds };
	const passed = seconds - before.seconds;
	const speed = mix(before.speed, (at - before.at) / passed, shareIn(passed, REST));
	const share = shareIn(passed, REST + HASTE * Math.abs(speed));
	return { at: mix(before.at, at, share), speed, seconds };
}

const mix = (one: number, other: number, share: number) => one + (other - one) * share;

/** Returns the weight of a new value in a low-pass filter of a cut-off frequency, after a time. */
function shareIn(seconds: number, hertz: number): number {
	const turns = 2 * Math.PI * hertz * seconds;
	return turns / (turns + 1);
}
