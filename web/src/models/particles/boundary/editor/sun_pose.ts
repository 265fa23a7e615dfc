/**
 * The sun as a grip on the sky seen from above: the zenith in the middle, the horizon at the rim, the front at the
 * bottom.
 */

import type { Specimen } from "../../../../specimen/specimen";
import type { Point } from "../../../../ui/handles/point";
import type { Pose } from "./grip";

/** Step of an arrow key without and with Shift, degrees. */
const STEP = 5;
const LARGE = 15;

const QUARTERS = ["in front", "at the front right", "at the right", "at the back right", "behind", "at the back left", "at the left", "at the front left"]; // biome-ignore format: a rose

/** Position of the sun on a disc of radius 1. */
export function sunPlace(azimuth: number, height: number): Point {
	const [out, angle] = [1 - height / 90, (azimuth * Math.PI) / 180];
	return { x: out * Math.sin(angle), y: -out * Math.cos(angle) };
}

/** The sun's direction at a point of the disc, integer degrees. */
export function sunAt({ x, y }: Point): { sun: number; sun_height: number } {
	const out = Math.min(1, Math.hypot(x, y));
	const azimuth = out < 1e-6 ? 0 : (Math.atan2(x, -y) * 180) / Math.PI;
	return { sun: (Math.round(azimuth) + 360) % 360, sun_height: Math.round(90 * (1 - out)) };
}

export function sunPose({ parameters }: Specimen, preset: Specimen): Pose {
	const { sun, sun_height } = parameters;
	const step = (large: boolean) => (large ? LARGE : STEP);
	return {
		grips: [
			{
				id: "sun",
				at: sunPlace(sun, sun_height),
				label: "Sun",
				value: `${sun_height}° high, ${QUARTERS[Math.round(sun / 45) % 8]}`,
				pull: (to) => ({ parameters: sunAt(to) }),
				nudge: (right, up, large) => ({
					parameters: {
						sun: (sun + right * step(large) + 360) % 360,
						sun_height: Math.min(90, Math.max(0, sun_height + up * step(large))),
					},
				}),
				reset: () => ({ parameters: { sun: preset.parameters.sun, sun_height: preset.parameters.sun_height } }),
			},
		],
		change: { parameters: { sun, sun_height } },
	};
}
