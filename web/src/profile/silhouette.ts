/** The grown bunch as a line drawing behind a view: orthographic, in pixels of the profile. */
import type { Berries, Internodes } from "../core/grown";
import { metresPerPixel, type View } from "./handles";

/** What is drawn of a growth; a whole `Grown` is one. */
export interface DrawnBunch {
	berries: Berries;
	internodes: Internodes;
}

export interface Disc {
	x: number;
	y: number;
	radius: number;
}

export interface Silhouette {
	/** Far ones first, so that each hides what is behind it. */
	berries: Disc[];
	/** SVG path data of all internodes. */
	stems: string;
}

/** Where the axes of a view lie in the bunch's frame: to the right, and towards the eye. */
const AXES: Record<View, { right: 0 | 2; eye: 0 | 2; towards: 1 | -1 }> = {
	front: { right: 0, eye: 2, towards: 1 },
	side: { right: 2, eye: 0, towards: -1 },
};

export function silhouette({ berries, internodes }: DrawnBunch, view: View, unit: number): Silhouette {
	const { right, eye, towards } = AXES[view];
	const pixel = metresPerPixel(unit);
	const order = Array.from({ length: berries.count }, (_, berry) => berry);
	const depth = (berry: number) => towards * berries.spheres[4 * berry + eye];
	order.sort((a, b) => depth(a) - depth(b));
	const at = (values: Float32Array, index: number) => Math.round((values[index] / pixel) * 10) / 10;
	return {
		berries: order.map((berry) => ({
			x: at(berries.spheres, 4 * berry + right),
			y: -at(berries.spheres, 4 * berry + 1),
			radius: at(berries.spheres, 4 * berry + 3),
		})),
		stems: stemPath(internodes, (index) => at(internodes.ends, index), right),
	};
}

function stemPath({ count }: Internodes, at: (index: number) => number, right: 0 | 2): string {
	let path = "";
	for (let internode = 0; internode < count; internode++) {
		const start = 6 * internode;
		const end = start + 3;
		path += `M${at(start + right)} ${-at(start + 1)}L${at(end + right)} ${-at(end + 1)}`;
	}
	return path;
}
