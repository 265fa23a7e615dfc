/** Draws the thickest branches as lines behind a flat view. */
import type { TrailPlant } from "../../trails";
import { type Facing, FROM_FRONT } from "./facing";
import type { BoundaryFrame } from "./frame";

/** Most lines that a canvas draws within a frame; the rest are twigs that would only blur the drawing. */
const MAX_SEGMENTS = 2500;
/** Number of energy classes; each starts at √2 times the energy of the one before. */
const CLASSES = 64;

/** Inputs of a drawing; equal inputs need no new drawing. */
interface DrawingInputs {
	readonly plant: TrailPlant | undefined;
	readonly frame: BoundaryFrame;
	readonly ratio: number;
	readonly ink: string;
}

export class BranchDrawing {
	readonly #facing: Facing;
	#lastInputs: DrawingInputs | undefined;

	constructor(facing: Facing = FROM_FRONT) {
		this.#facing = facing;
	}

	/** Draws in the canvas's colour at the screen's pixel ratio, where an input has changed. */
	show(canvas: HTMLCanvasElement, plant: TrailPlant | undefined, frame: BoundaryFrame): void {
		const inputs = { plant, frame, ratio: devicePixelRatio, ink: getComputedStyle(canvas).color };
		if (this.#lastInputs && sameInputs(this.#lastInputs, inputs)) return;
		this.#lastInputs = inputs;
		const [width, height] = [frame.width, frame.height].map((pixels) => Math.round(pixels * inputs.ratio));
		const pen = canvas.getContext("2d");
		// Setting the size also clears the canvas, but takes longer.
		if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
		pen?.setTransform(1, 0, 0, 1, 0, 0);
		pen?.clearRect(0, 0, width, height);
		if (pen && plant) inkBranches(pen, plant, inputs, this.#facing);
	}
}

/** Returns whether two drawings have equal inputs. */
function sameInputs(one: DrawingInputs, other: DrawingInputs): boolean {
	const valuesOf = ({ plant, frame: { width, height, scale, origin }, ratio, ink }: DrawingInputs) => [
		...[plant, width, height, scale, origin.x, origin.y, ratio, ink],
	];
	const otherValues = valuesOf(other);
	return valuesOf(one).every((part, i) => part === otherValues[i]);
}

type Pen = Pick<
	CanvasRenderingContext2D,
	"setTransform" | "beginPath" | "moveTo" | "lineTo" | "stroke" | "lineWidth" | "lineCap" | "strokeStyle"
>;

/** Least line width, CSS pixels. */
const HAIR = 0.6;

/**
 * Draws the heaviest branches of a plant as lines on the boundary's canvas, as wide as the branches but never invisibly
 * thin.
 */
export function inkBranches(
	pen: Pen,
	plant: TrailPlant,
	{ frame, ratio, ink }: Pick<DrawingInputs, "frame" | "ratio" | "ink">,
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
	for (const segment of heaviest(plant.energy, MAX_SEGMENTS)) {
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

/**
 * Returns the indices of about `most` segments with the most energy. It counts classes instead of sorting, because
 * there may be 100,000 segments.
 */
export function heaviest(energy: Float32Array, most: number): number[] {
	const classOf = (value: number) => Math.min(CLASSES - 1, Math.max(0, Math.floor(2 * Math.log2(Math.max(1, value)))));
	const counts = new Uint32Array(CLASSES);
	for (const value of energy) counts[classOf(value)]++;
	let [leastClass, sum] = [CLASSES, 0];
	while (leastClass > 0 && sum + counts[leastClass - 1] <= most) sum += counts[--leastClass];
	// Takes evenly spaced segments of the class that exceeds the limit.
	const interval = leastClass > 0 ? Math.ceil(counts[leastClass - 1] / Math.max(1, most - sum)) : 1;
	const chosen: number[] = [];
	let counted = 0;
	for (let i = 0; i < energy.length; i++) {
		const ownClass = classOf(energy[i]);
		if (ownClass >= leastClass || (ownClass === leastClass - 1 && counted++ % interval === 0)) chosen.push(i);
	}
	return chosen;
}
