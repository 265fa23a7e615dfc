/** Draws the thickest branches as lines behind a flat view. */
import type { TrailPlant } from "../../trails";
import { type Facing, FROM_FRONT } from "./facing";
import type { BoundaryFrame } from "./frame";

/** Most lines that a canvas draws within a frame; the rest are twigs that would only blur the drawing. */
const MOST = 2500;
/** Number of energy classes; each starts at √2 times the energy of the one before. */
const CLASSES = 64;

/** Inputs of a drawing; equal inputs need no new drawing. */
interface Drawn {
	readonly plant: TrailPlant | undefined;
	readonly frame: BoundaryFrame;
	readonly ratio: number;
	readonly ink: string;
}

export class BranchDrawing {
	readonly #facing: Facing;
	#drawn: Drawn | undefined;

	constructor(facing: Facing = FROM_FRONT) {
		this.#facing = facing;
	}

	/** Draws in the canvas's colour at the screen's pixel ratio, where an input has changed. */
	show(canvas: HTMLCanvasElement, plant: TrailPlant | undefined, frame: BoundaryFrame): void {
		const now = { plant, frame, ratio: devicePixelRatio, ink: getComputedStyle(canvas).color };
		if (this.#drawn && same(this.#drawn, now)) return;
		this.#drawn = now;
		const [width, height] = [frame.width, frame.height].map((pixels) => Math.round(pixels * now.ratio));
		const pen = canvas.getContext("2d");
		// Setting the size also clears the canvas, but takes longer.
		if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
		pen?.setTransform(1, 0, 0, 1, 0, 0);
		pen?.clearRect(0, 0, width, height);
		if (pen && plant) inkBranches(pen, plant, now, this.#facing);
	}
}

function same(one: Drawn, other: Drawn): boolean {
	const parts = ({ plant, frame: { width, height, scale, origin }, ratio, ink }: Drawn) => [
		...[plant, width, height, scale, origin.x, origin.y, ratio, ink],
	];
	const others = parts(other);
	return parts(one).every((part, i) => part === others[i]);
}

type Pen = Pick<
	CanvasRenderingContext2D,
	"setTransform" | "beginPath" | "moveTo" | "lineTo" | "stroke" | "lineWidth" | "lineCap" | "strokeStyle"
>;

/** Least line width, CSS pixels. */
const HAIR = 0.6;

export function inkBranches(
	pen: Pen,
	plant: TrailPlant,
	{ frame, ratio, ink }: Pick<Drawn, "frame" | "ratio" | "ink">,
	{ up, sign }: Facing = FROM_FRONT,
): void {
	const { scale, origin } = frame;
	const { ends, radii } = plant.segments;
	const zoom = ratio * scale;
	pen.setTransform(zoom, 0, 0, -sign * zoom, ratio * origin.x, ratio * origin.y);
	pen.strokeStyle = ink;
	pen.lineCap = "round";
	// One path per line width, in steps of a factor of 1.5.
	const byWidth = new Map<number, number[]>();
	for (const segment of heaviest(plant.energy, MOST)) {
		const pixels = Math.max(HAIR, 2 * radii[2 * segment] * scale);
		const step = Math.round(Math.log(pixels / HAIR) / Math.log(1.5));
		const group = byWidth.get(step);
		if (group) group.push(segment);
		else byWidth.set(step, [segment]);
	}
	for (const [step, segments] of byWidth) {
		pen.lineWidth = (HAIR * 1.5 ** step) / scale;
		pen.beginPath();
		for (const segment of segments) {
			const at = 6 * segment;
			pen.moveTo(ends[at], ends[at + up]);
			pen.lineTo(ends[at + 3], ends[at + 3 + up]);
		}
		pen.stroke();
	}
}

/** About `most` segments with the most energy. It counts classes, because there may be 100,000 segments. */
export function heaviest(energy: Float32Array, most: number): number[] {
	const classOf = (value: number) => Math.min(CLASSES - 1, Math.max(0, Math.floor(2 * Math.log2(Math.max(1, value)))));
	const counts = new Uint32Array(CLASSES);
	for (const value of energy) counts[classOf(value)]++;
	let [least, sum] = [CLASSES, 0];
	while (least > 0 && sum + counts[least - 1] <= most) sum += counts[--least];
	// Takes evenly spaced segments of the class that exceeds the limit.
	const every = least > 0 ? Math.ceil(counts[least - 1] / Math.max(1, most - sum)) : 1;
	const chosen: number[] = [];
	let seen = 0;
	for (let i = 0; i < energy.length; i++) {
		const own = classOf(energy[i]);
		if (own >= least || (own === least - 1 && seen++ % every === 0)) chosen.push(i);
	}
	return chosen;
}
