import { Matrix3, Vector3 } from "three";
import type { Colour } from "../plant/colour";

export type Theme = "light" | "dark";

/**
 * A lobe of the surroundings' light: a spherical Gaussian, colour · exp(sharpness · (cos γ − 1)) (Wang et al. 2009,
 * "All-frequency rendering of dynamic, spatially-varying reflectance", section 3). The environment is a sum of a few
 * lobes: their blur for a rough surface or for diffuse light has a closed form, so nothing is filtered or loaded.
 */
export interface Lobe {
	axis: Vector3;
	sharpness: number;
	colour: Colour;
}

/** A window or a softbox: a rectangle at infinity, given by tangents of its half angles. */
export interface WindowLight {
	direction: Vector3;
	half: [across: number, along: number];
	/** Irradiance on a surface facing it. */
	irradiance: Colour;
	/** Width of the glazing bars as a tangent; 0 for a plain softbox. */
	bars: number;
}

/** All light of the scene. Directions are in view space: +X right, +Y up, +Z towards the eye. */
export interface LightRig {
	/** Whether directions are in the plant's frame instead: the light does not turn with the viewer. */
	fixed?: true;
	key: WindowLight;
	rim: WindowLight;
	surroundings: Lobe[];
	/**
	 * Greatest darkness of the plant's shadow on the paper, and direction of its light: lower than the key light,
	 * whose shadow would be outside the picture.
	 */
	shadow: { depth: number; direction: Vector3 };
	/** Colours of the paper: at its edges (the page's own colour) and where the light falls, sRGB hexadecimal. */
	paper: { edge: string; pool: string };
	/** Sky for a viewer within the plant, sRGB hexadecimal: the paper would look black over lit ground. */
	sky: { horizon: string; zenith: string };
}

/** Returns the unit vector of a direction. */
const toward = (x: number, y: number, z: number) => new Vector3(x, y, z).normalize();

const RIGS: Record<Theme, LightRig> = {
	light: {
		key: { direction: toward(-0.62, 0.66, 0.62), half: [0.26, 0.36], irradiance: [3, 2.84, 2.6], bars: 0.022 },
		rim: { direction: toward(0.75, 0.3, -0.6), half: [0.16, 0.7], irradiance: [2.1, 1.95, 1.7], bars: 0 },
		surroundings: [
			{ axis: toward(-0.1, 1, 0.15), sharpness: 1.6, colour: [0.44, 0.5, 0.6] },
			{ axis: toward(0.1, -1, 0.25), sharpness: 1.7, colour: [0.3, 0.25, 0.2] },
			{ axis: toward(0, 0, -1), sharpness: 2.2, colour: [0.62, 0.58, 0.5] },
			{ axis: toward(0.75, 0.05, 0.65), sharpness: 2, colour: [0.2, 0.2, 0.21] },
		],
		shadow: { depth: 0.42, direction: toward(-0.5, 0.3, 0.85) },
		paper: { edge: "f4efe4", pool: "fbf8f1" },
		sky: { horizon: "f6f3ea", zenith: "b4cbdd" },
	},
	dark: {
		key: { direction: toward(-0.66, 0.62, 0.5), half: [0.26, 0.36], irradiance: [4.3, 4.0, 3.55], bars: 0.022 },
		rim: { direction: toward(0.78, 0.26, -0.56), half: [0.18, 0.8], irradiance: [4.2, 3.5, 2.7], bars: 0 },
		surroundings: [
			{ axis: toward(-0.2, 1, 0.1), sharpness: 2, colour: [0.17, 0.23, 0.34] },
			{ axis: toward(0.1, -1, 0.25), sharpness: 1.8, colour: [0.12, 0.08, 0.05] },
			{ axis: toward(0, 0, -1), sharpness: 2.2, colour: [0.08, 0.06, 0.05] },
			{ axis: toward(0.75, 0.05, 0.65), sharpness: 2, colour: [0.1, 0.09, 0.09] },
		],
		shadow: { depth: 0.7, direction: toward(-0.5, 0.3, 0.85) },
		paper: { edge: "14100e", pool: "33271f" },
		sky: { horizon: "9a8d88", zenith: "29334a" },
	},
};

/** Returns the light of a colour scheme of the page. */
export function rigOf(theme: Theme): LightRig {
	return RIGS[theme];
}

/** Sharpness of the Gaussian that fits a clamped cosine best (Tsai & Shih 2006). */
export const COSINE_SHARPNESS = 2.133;
/** Sharpness of the mirror lobe of a taut skin: GGX roughness of about 0.25 (Wang et al. 2009, equation 21: 2/α²). */
export const GLOSS_SHARPNESS = 32;

/**
 * Returns the integral of a lobe of height 1 over the sphere: ∫ exp(s (cos γ − 1)) dω = 2π (1 − exp(−2 s)) / s, s the
 * sharpness.
 */
function integral(sharpness: number): number {
	return (2 * Math.PI * (1 - Math.exp(-2 * sharpness))) / sharpness;
}

/**
 * Convolves the lobe with a unit Gaussian of the given sharpness: values of 1/sharpness add up like variances, and the
 * integral stays the same.
 */
export function blurred(lobe: Lobe, sharpness: number): Lobe {
	const combined = (lobe.sharpness * sharpness) / (lobe.sharpness + sharpness);
	const gain = integral(lobe.sharpness) / integral(combined);
	const [red, green, blue] = lobe.colour;
	return { axis: lobe.axis, sharpness: combined, colour: [red * gain, green * gain, blue * gain] };
}

/** Returns the tangent of the apparent radius of a round lamp with the window's area. */
export function spreadOf(window: WindowLight): number {
	return 2 * Math.sqrt((window.half[0] * window.half[1]) / Math.PI) * 0.5;
}

/**
 * Returns the rotation from view space into a window's frame: x across, y along (as upright as possible), z towards it.
 */
export function frameOf(window: WindowLight): Matrix3 {
	const across = new Vector3(0, 1, 0).cross(window.direction).normalize();
	const along = window.direction.clone().cross(across);
	const d = window.direction;
	return new Matrix3(across.x, across.y, across.z, along.x, along.y, along.z, d.x, d.y, d.z);
}
