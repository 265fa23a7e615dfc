/** Handles of growth volumes in the 3-D view: each volume's position, and the chosen one's height, lean and widths. */

import { formatNumber } from "../../../locale/format";
import type { Change } from "../../../ui/editor_context";
import type { HandleVector, PlantHandle, PlantHandles } from "../../../ui/handles/plant_handle";
import { text } from "../messages.generated";
import { acrossOf, axisOf, type GrowthVolume, HIGHEST, LOWEST, meanWidth, placeIn, radiusAt, WIDEST } from "./volume";

/** Metres that an arrow key moves, alone and with Shift; degrees of a lean. */
const STEP = 0.1;
const LARGE_STEP = 1;
const TURN = 2;
const LARGE_TURN = 10;
/** Limit of dragged volumes; the core allows the same and more (models/growth/volumes.cpp). */
const STEEPEST = 80;
const SIDES = 24;

/** Formats a number with one decimal, in the language in use. */
const tenths = (value: number): string => formatNumber(value, { minimumFractionDigits: 1, maximumFractionDigits: 1 });
/** Formats a length in metres. */
const metres = (value: number): string => `${tenths(value)} m`;
/** Limits a value to a range. */
const within = (value: number, least: number, most: number): number => Math.min(most, Math.max(least, value));
/** Returns the dot product of two vectors. */
const dot = (a: HandleVector, b: HandleVector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
/** Returns the difference a − b of two vectors. */
const difference = (a: HandleVector, b: HandleVector): HandleVector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** Returns the name of a volume: "Growth volume 2". */
export const nameOf = (index: number): string => text("volume", { number: index + 1 });

/**
 * Returns the handles of volumes.
 * @param changeAll returns the change that sets the volumes
 */
export function volumeHandles(
	volumes: readonly GrowthVolume[],
	chosen: number,
	changeAll: (volumes: readonly GrowthVolume[]) => Change,
): PlantHandles {
	const changeOne = (index: number, change: Partial<GrowthVolume>): Change =>
		changeAll(volumes.map((volume, i) => (i === index ? { ...volume, ...change } : volume)));
	const chosenVolume = volumes[chosen];
	return {
		handles: [
			...volumes.map((volume, i) => ({
				...footHandle(volume, i, (change) => changeOne(i, change)),
				...(i === chosen ? { kind: "chosen" as const } : {}),
				...(volumes.length > 1 ? { remove: () => changeAll(volumes.filter((_, other) => other !== i)) } : {}),
			})),
			...(chosenVolume ? shapeHandles(chosenVolume, chosen, (change) => changeOne(chosen, change)) : []),
		],
		lines: chosenVolume
			? [
					...[0, 0.5, 1].map((up) => ring(chosenVolume, up, radiusAt(chosenVolume, up))),
					[placeIn(chosenVolume, 0), placeIn(chosenVolume, 1)],
				]
			: [],
	};
}

/**
 * Returns a closed circle around a volume's axis as a polyline.
 * @param share of the volume's height
 * @param radius metres
 */
const ring = (volume: GrowthVolume, share: number, radius: number): readonly HandleVector[] =>
	Array.from({ length: SIDES + 1 }, (_, i) => placeIn(volume, share, radius, (360 * i) / SIDES));

/** Returns the change that sets some numbers of one volume. */
type VolumeChanger = (change: Partial<GrowthVolume>) => Change;

/** Returns the handle at a volume's foot, which moves it on the ground. */
function footHandle(volume: GrowthVolume, index: number, change: VolumeChanger): PlantHandle {
	const [x, z] = volume.at;
	return {
		id: `volume-${index}`,
		label: nameOf(index),
		value: `x ${tenths(x)}, z ${tenths(z)}`,
		at: placeIn(volume, 0),
		along: [
			[1, 0, 0],
			[0, 0, 1],
		],
		pull: ([toX, , toZ]) => change({ at: [toX, toZ] }),
		nudge: (right, up, large) => {
			const step = large ? LARGE_STEP : STEP;
			return change({ at: [x + right * step, z - up * step] });
		},
	};
}

/** Returns the handles of one volume's shape. */
function shapeHandles(volume: GrowthVolume, index: number, change: VolumeChanger): PlantHandle[] {
	const number = index + 1;
	const axis = axisOf(volume);
	const base = placeIn(volume, 0);
	/**
	 * Returns the handle of a width.
	 * @param share height of the handle as a share of the volume's
	 */
	const width = (key: "base" | "middle" | "top", share: number): PlantHandle => {
		const centre = placeIn(volume, share);
		const widthDirection = acrossOf(volume);
		const straight = volume.middle === meanWidth(volume.base, volume.top);
		// A frustum stays one when either end is dragged.
		const withWidth = (value: number) => {
			const changedVolume = { ...volume, [key]: within(value, 0, WIDEST) };
			if (key !== "middle" && straight) changedVolume.middle = meanWidth(changedVolume.base, changedVolume.top);
			return change(changedVolume);
		};
		return {
			id: key,
			label: text(`volume_${key}`, { number }),
			value: metres(volume[key]),
			kind: "size",
			at: placeIn(volume, share, volume[key] / 2),
			along: [widthDirection],
			pull: (to) => withWidth(2 * dot(difference(to, centre), widthDirection)),
			nudge: (right, higher, large) => withWidth(volume[key] + (right || higher) * (large ? LARGE_STEP : STEP)),
		};
	};
	const withHeight = (value: number) => change({ height: within(value, LOWEST, HIGHEST) });
	const height: PlantHandle = {
		id: "height",
		label: text("volume_height", { number }),
		value: metres(volume.height),
		kind: "size",
		at: placeIn(volume, 1),
		along: [axis],
		pull: (to) => withHeight(dot(difference(to, base), axis)),
		nudge: (right, share, large) => withHeight(volume.height + (share || right) * (large ? LARGE_STEP : STEP)),
	};
	return [height, leanHandle(volume, number, change), width("base", 0), width("middle", 0.5), width("top", 1)];
}

/** Returns the handle of the lean and its direction, at three quarters of the height. */
function leanHandle(volume: GrowthVolume, number: number, change: VolumeChanger): PlantHandle {
	const base = placeIn(volume, 0);
	return {
		id: "lean",
		label: text("volume_lean", { number }),
		value: text("lean_value", { lean: volume.gradient.toFixed(0), direction: volume.towards.toFixed(0) }),
		kind: "turn",
		at: placeIn(volume, 0.75),
		along: [
			[1, 0, 0],
			[0, 1, 0],
			[0, 0, 1],
		],
		pull: (to) => {
			const [x, y, z] = difference(to, base);
			const distance = Math.hypot(x, z);
			const gradient = within((Math.atan2(distance, y) * 180) / Math.PI, 0, STEEPEST);
			// An upright volume keeps its direction of lean.
			return change(distance > 0.01 ? { gradient, towards: (Math.atan2(z, x) * 180) / Math.PI } : { gradient });
		},
		nudge: (right, up, large) => {
			const step = large ? LARGE_TURN : TURN;
			const towards = ((volume.towards + right * step + 540) % 360) - 180;
			return change({ gradient: within(volume.gradient - up * step, -STEEPEST, STEEPEST), towards });
		},
	};
}
