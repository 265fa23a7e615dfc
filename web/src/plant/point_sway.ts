/** How one point of a swaying plant moves, for files. Shaders have the same in render/wind_shader.ts. */
import type { Vector } from "./part";
import { BRANCH, FLUTTER, LEAF_ANGLE, PHASE_LAGS, type Sway, TOP_AMPLITUDE } from "./sway";

/** Displacement of a point: coefficients of the sine and the cosine of the time's angle. */
export interface Swing {
	readonly sine: Vector;
	readonly cosine: Vector;
}

/** Clamps to 0 … 1. */
const clamped = (value: number) => Math.min(1, Math.max(0, value));

/**
 * Returns the motion of a point.
 * @param held the fixed point of its part, where it has one; else the point itself
 */
export function swing({ foot, up, height, reach }: Sway, place: Vector, held: Vector = place): Swing {
	const [dx, dy, dz] = [held[0] - foot[0], held[1] - foot[1], held[2] - foot[2]];
	const h = clamped((up * dy) / height);
	const r = clamped(Math.hypot(dx, dz) / reach);
	const bend = TOP_AMPLITUDE * height * h * h * (1.5 - 0.5 * h);
	const bob = BRANCH * reach * r * r * h * (2 - h);
	const size = Math.max(height, reach);
	const late = (PHASE_LAGS * (0.8 * dx + 0.5 * dy + 0.6 * dz)) / size;
	const [c, s] = [bob * Math.cos(late), bob * Math.sin(late)];
	const own = (FLUTTER * (held[0] + 1.7 * held[1] + 2.3 * held[2])) / size;
	// Fallen parts do not turn.
	const turns = LEAF_ANGLE * Math.min(1, 8 * h);
	const [lc, ls] = [turns * Math.cos(own), turns * Math.sin(own)];
	// Turn about the horizontal axis across the wind.
	const [ox, oy, oz] = [place[0] - held[0], place[1] - held[1], place[2] - held[2]];
	const turn: Vector = [-0.8 * oy, 0.8 * ox + 0.6 * oz, -0.6 * oy];
	const along = bend + c;
	const across = 0.4 * bend + 0.5 * c;
	return {
		sine: [0.8 * along - 0.3 * s + lc * turn[0], 0.6 * c + lc * turn[1], 0.6 * along + 0.4 * s + lc * turn[2]],
		cosine: [-0.8 * s - 0.6 * across - ls * turn[0], -0.6 * s - ls * turn[1], -0.6 * s + 0.8 * across - ls * turn[2]],
	};
}
