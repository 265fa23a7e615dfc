/** Handles of growth volumes in the 3-D view: each volume's position, and the chosen one's height, lean and widths. */
import type { Change } from "../../../ui/editor_context";
import type { HandleVector, PlantHandle, PlantHandles } from "../../../ui/handles/plant_handle";
import { acrossOf, axisOf, type GrowthVolume, meanWidth, placeIn, radiusAt } from "./volume";

/** Metres that an arrow key moves, alone and with Shift; degrees of a lean. */
const STEP = 0.1;
const STRIDE = 1;
const TURN = 2;
const TURN_FAR = 10;
/** Limits of dragged volumes; the core allows the same and more (models/growth/volumes.cpp). */
const LOWEST = 0.5;
const HIGHEST = 100;
const WIDEST = 100;
const STEEPEST = 80;
const SIDES = 24;

const metres = (value: number): string => `${value.toFixed(1)} m`;
const within = (value: number, least: number, most: number): number => Math.min(most, Math.max(least, value));
const dot = (a: HandleVector, b: HandleVector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const from = (a: HandleVector, b: HandleVector): HandleVector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];

/** Returns the name of a volume: "Growth volume 2". */
export const nameOf = (index: number): string => `Growth volume ${index + 1}`;

/**
 * Returns the handles of volumes.
 * @param put returns the change that sets the volumes
 */
export function volumeHandles(
	volumes: readonly GrowthVolume[],
	chosen: number,
	put: (volumes: readonly GrowthVolume[]) => Change,
): PlantHandles {
	const changed = (index: number, change: Partial<GrowthVolume>): Change =>
		put(volumes.map((volume, i) => (i === index ? { ...volume, ...change } : volume)));
	const one = volumes[chosen];
	return {
		handles: [
			...volumes.map((volume, i) => ({
				...foot(volume, i, (change) => changed(i, change)),
				...(i === chosen ? { kind: "chosen" as const } : {}),
				...(volumes.length > 1 ? { remove: () => put(volumes.filter((_, other) => other !== i)) } : {}),
			})),
			...(one ? shape(one, chosen, (change) => changed(chosen, change)) : []),
		],
		lines: one
			? [...[0, 0.5, 1].map((up) => ring(one, up, radiusAt(one, up))), [placeIn(one, 0), placeIn(one, 1)]]
			: [],
	};
}

const ring = (volume: GrowthVolume, up: number, out: number): readonly HandleVector[] =>
	Array.from({ length: SIDES + 1 }, (_, i) => placeIn(volume, up, out, (360 * i) / SIDES));

type Put = (change: Partial<GrowthVolume>) => Change;

function foot(volume: GrowthVolume, index: number, put: Put): PlantHandle {
	const [x, z] = volume.at;
	return {
		id: `volume-${index}`,
		label: nameOf(index),
		value: `x ${x.toFixed(1)}, z ${z.toFixed(1)}`,
		at: placeIn(volume, 0),
		along: [
			[1, 0, 0],
			[0, 0, 1],
		],
		pull: ([toX, , toZ]) => put({ at: [toX, toZ] }),
		nudge: (right, up, large) => {
			const by = large ? STRIDE : STEP;
			return put({ at: [x + right * by, z - up * by] });
		},
	};
}

function shape(volume: GrowthVolume, index: number, put: Put): PlantHandle[] {
	const of = `of growth volume ${index + 1}`;
	const axis = axisOf(volume);
	const base = placeIn(volume, 0);
	const width = (key: "base" | "middle" | "top", up: number, label: string): PlantHandle => {
		const middle = placeIn(volume, up);
		const across = acrossOf(volume);
		const straight = volume.middle === meanWidth(volume.base, volume.top);
		// A frustum stays one when either end is dragged.
		const wide = (value: number) => {
			const changed = { ...volume, [key]: within(value, 0, WIDEST) };
			if (key !== "middle" && straight) changed.middle = meanWidth(changed.base, changed.top);
			return put(changed);
		};
		return {
			id: key,
			label: `${label} ${of}`,
			value: metres(volume[key]),
			kind: "size",
			at: placeIn(volume, up, volume[key] / 2),
			along: [across],
			pull: (to) => wide(2 * dot(from(to, middle), across)),
			nudge: (right, higher, large) => wide(volume[key] + (right || higher) * (large ? STRIDE : STEP)),
		};
	};
	const tall = (value: number) => put({ height: within(value, LOWEST, HIGHEST) });
	const height: PlantHandle = {
		id: "height",
		label: `Height ${of}`,
		value: metres(volume.height),
		kind: "size",
		at: placeIn(volume, 1),
		along: [axis],
		pull: (to) => tall(dot(from(to, base), axis)),
		nudge: (right, up, large) => tall(volume.height + (up || right) * (large ? STRIDE : STEP)),
	};
	return [
		height,
		lean(volume, of, put),
		width("base", 0, "Width at the base"),
		width("middle", 0.5, "Width in the middle"),
		width("top", 1, "Width at the top"),
	];
}

/** Returns the handle of the lean and its direction, at three quarters of the height. */
function lean(volume: GrowthVolume, of: string, put: Put): PlantHandle {
	const base = placeIn(volume, 0);
	return {
		id: "lean",
		label: `Lean ${of}`,
		value: `${volume.gradient.toFixed(0)}°, towards ${volume.towards.toFixed(0)}°`,
		kind: "turn",
		at: placeIn(volume, 0.75),
		along: [
			[1, 0, 0],
			[0, 1, 0],
			[0, 0, 1],
		],
		pull: (to) => {
			const [x, y, z] = from(to, base);
			const out = Math.hypot(x, z);
			const gradient = within((Math.atan2(out, y) * 180) / Math.PI, 0, STEEPEST);
			// An upright volume keeps its direction of lean.
			return put(out > 0.01 ? { gradient, towards: (Math.atan2(z, x) * 180) / Math.PI } : { gradient });
		},
		nudge: (right, up, large) => {
			const by = large ? TURN_FAR : TURN;
			const towards = ((volume.towards + right * by + 540) % 360) - 180;
			return put({ gradient: within(volume.gradient - up * by, -STEEPEST, STEEPEST), towards });
		},
	};
}
