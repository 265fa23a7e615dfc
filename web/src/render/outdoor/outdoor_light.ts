/** Light outdoors: the sun, the sky, and the light from the ground. */
import { Vector3 } from "three";
import type { LightRig, Theme } from "../light";

/** Returns the unit vector of a direction. @param azimuth, elevation degrees; azimuth 0 is +Z, 90 is +X */
function direction(azimuth: number, elevation: number): Vector3 {
	const [a, e] = [(azimuth * Math.PI) / 180, (elevation * Math.PI) / 180];
	return new Vector3(Math.sin(a) * Math.cos(e), Math.sin(e), Math.cos(a) * Math.cos(e));
}

/**
 * Azimuth of the sun, degrees: in the first view (azimuth 24) it shines from the left, a little from the front, so that
 * a crown has a sunny and a shady side.
 */
const SUN = -36;
/** Apparent half size of the sun with the bright sky about it, as tangents: shadows are softer than on a clear day. */
const SUN_SIZE = 0.05;

/** Properties of the sky that are not light: for its picture. Linear light is in the rig; these are sRGB hexadecimal. */
export interface SkyLook {
	horizon: string;
	zenith: string;
	/** Glow of the air about the sun. */
	glow: string;
	cloud: string;
	/** Hills at the horizon: the far ones and the near ones. */
	far: string;
	near: string;
	/** Grass in the light of this sky, linear factor on its colour. */
	grass: string;
}

const LIGHTS: Record<Theme, LightRig> = {
	light: {
		fixed: true,
		key: { direction: direction(SUN, 42), half: [SUN_SIZE, SUN_SIZE], irradiance: [4.3, 3.95, 3.35], bars: 0 },
		rim: { direction: direction(SUN + 180, 20), half: [0.2, 0.2], irradiance: [0, 0, 0], bars: 0 },
		surroundings: [
			{ axis: new Vector3(0, 1, 0), sharpness: 1.1, colour: [0.5, 0.6, 0.78] },
			{ axis: new Vector3(0, -1, 0), sharpness: 1.6, colour: [0.3, 0.31, 0.16] },
			{ axis: direction(SUN, 10), sharpness: 1.6, colour: [0.42, 0.4, 0.36] },
			{ axis: direction(SUN + 180, 10), sharpness: 1.4, colour: [0.24, 0.26, 0.3] },
		],
		shadow: { depth: 0, direction: direction(SUN, 42) },
		paper: { edge: "f4efe4", pool: "fbf8f1" },
		sky: { horizon: "d9e6ee", zenith: "7fb0d8" },
	},
	dark: {
		fixed: true,
		key: { direction: direction(SUN, 16), half: [SUN_SIZE, SUN_SIZE], irradiance: [3.3, 2.2, 1.25], bars: 0 },
		rim: { direction: direction(SUN + 180, 20), half: [0.2, 0.2], irradiance: [0, 0, 0], bars: 0 },
		surroundings: [
			{ axis: new Vector3(0, 1, 0), sharpness: 1.1, colour: [0.2, 0.24, 0.38] },
			{ axis: new Vector3(0, -1, 0), sharpness: 1.6, colour: [0.1, 0.09, 0.06] },
			{ axis: direction(SUN, 6), sharpness: 2, colour: [0.34, 0.25, 0.18] },
			{ axis: direction(SUN + 180, 10), sharpness: 1.4, colour: [0.12, 0.12, 0.18] },
		],
		shadow: { depth: 0, direction: direction(SUN, 16) },
		paper: { edge: "14100e", pool: "33271f" },
		sky: { horizon: "c08e6c", zenith: "2c3c5c" },
	},
};

const LOOKS: Record<Theme, SkyLook> = {
	light: {
		horizon: "dbe7ee",
		zenith: "6fa5d3",
		glow: "fff3dc",
		cloud: "ffffff",
		far: "a9bfc9",
		near: "8aa491",
		grass: "71774a",
	},
	dark: {
		horizon: "c9977a",
		zenith: "2a3a5a",
		glow: "f2b98a",
		cloud: "d8a58e",
		far: "5d5a6a",
		near: "3a3f42",
		grass: "666b44",
	},
};

/** Returns the light outdoors: by day, or in the evening for the dark colour scheme. */
export const outdoorRig = (theme: Theme): LightRig => LIGHTS[theme];

/** Returns the colours of the sky and the land outdoors. */
export const skyLook = (theme: Theme): SkyLook => LOOKS[theme];
