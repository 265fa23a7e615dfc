/** The grown bunch as a line drawing behind a view: orthographic, in pixels of the profile. */
import { type Berries, type Internodes, TRAITS } from "../grown";
import { metresPerPixel, type View } from "./handles";

/** What is drawn of a growth; a whole `Grown` is one. */
export interface DrawnBunch {
	berries: Berries;
	internodes: Internodes;
}

/** A berry's outline: half its axes, and by how many degrees the first is turned clockwise on the page. */
export interface Outline {
	x: number;
	y: number;
	rx: number;
	ry: number;
	turn: number;
}

export interface Silhouette {
	/** Far ones first, so that each hides what is behind it. */
	berries: Outline[];
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
	const at = (values: Float32Array, index: number) => tenth(values[index] / pixel);
	return {
		berries: order.map((berry) => ({
			x: at(berries.spheres, 4 * berry + right),
			y: -at(berries.spheres, 4 * berry + 1),
			...outlineOf(berries, berry, right, pixel),
		})),
		stems: stemPath(internodes, (index) => at(internodes.ends, index), right),
	};
}

/** The ellipse that a berry, an ellipsoid about its own direction, is seen as. */
function outlineOf({ directions, traits }: Berries, berry: number, right: 0 | 2, pixel: number) {
	const [width, length] = [WIDTH, LENGTH].map((trait) => traits[TRAITS.length * berry + trait] / pixel);
	const [along, up] = [directions[3 * berry + right], directions[3 * berry + 1]];
	// What is seen of the direction, as a share: 1 from the side, 0 end on.
	const seen = along * along + up * up;
	const rx = Math.sqrt(seen * length * length + (1 - seen) * width * width) / 2;
	const turn = (Math.atan2(-up, along) * 180) / Math.PI;
	return { rx: tenth(rx), ry: tenth(width / 2), turn: Math.round(turn) + 0 };
}

const WIDTH = TRAITS.indexOf("width");
const LENGTH = TRAITS.indexOf("length");

function tenth(value: number): number {
	return Math.round(value * 10) / 10;
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
