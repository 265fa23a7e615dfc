/**
 * The sun as a grip on the sky seen from above: the zenith in the middle, the horizon at the rim, the front at the
 * bottom.
 */

import type { Specimen } from "../../../../specimen/specimen";
import type { Point } from "../../../../ui/handles/point";
import { text } from "../../messages.generated";
import type { Pose } from "./grip";

/** Step of an arrow key without and with Shift, degrees. */
const STEP = 5;
const LARGE_STEP = 15;

const QUARTERS = ["front", "front_right", "right", "back_right", "back", "back_left", "left", "front_left"]; // biome-ignore format: a rose

/** Returns the position of the sun on a disc of radius 1, from azimuth and height above the horizon in degrees. */
export function sunPlace(azimuth: number, height: number): Point {
	const [radius, angle] = [1 - height / 90, (azimuth * Math.PI) / 180];
	return { x: radius * Math.sin(angle), y: -radius * Math.cos(angle) };
}

/** Returns the sun's direction at a point of the disc, integer degrees: the inverse of `sunPlace`. */
export function sunAt({ x, y }: Point): { sun: number; sun_height: number } {
	const radius = Math.min(1, Math.hypot(x, y));
	const azimuth = radius < 1e-6 ? 0 : (Math.atan2(x, -y) * 180) / Math.PI;
	return { sun: (Math.round(azimuth) + 360) % 360, sun_height: Math.round(90 * (1 - radius)) };
}

/** Returns the handle of the sun: its direction and height above the horizon. */
export function sunPose({ parameters }: Specimen, preset: Specimen): Pose {
	const { sun, sun_height } = parameters;
	const step = (large: boolean) => (large ? LARGE_STEP : STEP);
	return {
		grips: [
			{
				id: "sun",
				at: sunPlace(sun, sun_height),
				label: text("sun"),
				value: text("sun_value", { height: sun_height, direction: QUARTERS[Math.round(sun / 45) % 8] }),
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
