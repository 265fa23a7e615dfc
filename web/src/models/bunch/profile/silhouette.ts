/** Line drawing of the grown bunch behind a view: orthographic, in pixels of the profile. */
import { type Berries, type Internodes, type OwnProfile, TRAITS } from "../bunch_plant";
import { metresPerPixel, type View } from "./handles";

/** Drawn data of a bunch; a whole `BunchPlant` fits. */
export interface DrawnBunch {
	berries: Berries;
	internodes: Internodes;
	/** Outline that it fills, if known. */
	profile?: OwnProfile;
}

/** Outline of a berry: half its axes, and the clockwise rotation of the first on the page, in radians. */
export interface BerryOutline {
	x: number;
	y: number;
	rx: number;
	ry: number;
	turn: number;
}

/** Start and end of an internode. */
export type Stroke = readonly [x1: number, y1: number, x2: number, y2: number];

export interface Silhouette {
	/** Berries, farthest first, so that each hides those behind it. */
	berries: BerryOutline[];
	stems: Stroke[];
}

/** Axes of a view in the bunch's frame: rightward, and towards the eye. */
const AXES: Record<View, { right: 0 | 2; eye: 0 | 2; towards: 1 | -1 }> = {
	front: { right: 0, eye: 2, towards: 1 },
	side: { right: 2, eye: 0, towards: -1 },
};

/**
 * Projects berries and stems onto a view's plane, in pixels of the profile, the farthest berry first.
 * @param unit millimetres per unit of the paper
 */
export function silhouette({ berries, internodes }: DrawnBunch, view: View, unit: number): Silhouette {
	const { right, eye, towards } = AXES[view];
	const pixel = metresPerPixel(unit);
	const order = Array.from({ length: berries.count }, (_, berry) => berry);
	const depth = (berry: number) => towards * berries.spheres[4 * berry + eye];
	order.sort((a, b) => depth(a) - depth(b));
	return {
		berries: order.map((berry) => ({
			x: berries.spheres[4 * berry + right] / pixel,
			y: -berries.spheres[4 * berry + 1] / pixel,
			...outlineOf(berries, berry, right, pixel),
		})),
		stems: Array.from({ length: internodes.count }, (_, internode) => {
			const at = (offset: number) => internodes.ends[6 * internode + offset] / pixel;
			return [at(right), -at(1), at(3 + right), -at(4)] as const;
		}),
	};
}

/**
 * Returns the visible ellipse of a berry, an ellipsoid about its own direction, in pixels of the profile.
 * @param right the axis to the right of the view: 0 for x, 2 for z
 * @param pixel metres per pixel
 */
function outlineOf({ directions, traits }: Berries, berry: number, right: 0 | 2, pixel: number) {
	const [width, length] = [WIDTH, LENGTH].map((trait) => traits[TRAITS.length * berry + trait] / pixel);
	// The direction's components on the page.
	const [across, up] = [directions[3 * berry + right], directions[3 * berry + 1]];
	// Visible share of the direction: 1 from the side, 0 end on.
	const seen = across * across + up * up;
	const rx = Math.sqrt(seen * length * length + (1 - seen) * width * width) / 2;
	return { rx, ry: width / 2, turn: Math.atan2(-up, across) };
}

const WIDTH = TRAITS.indexOf("width");
const LENGTH = TRAITS.indexOf("length");
