/** Finds the silhouette of one object on a plain background, without holes. */
import { text } from "../messages.generated";
import { type Mask, type PixelImage, TraceError } from "./picture";

/** Least colour difference from the background that counts as foreground, 0 … 441. */
const LEAST_CONTRAST = 26;
/** Least area of a silhouette, as a share of the picture. */
const LEAST_SHARE = 0.005;
/** A silhouette that covers more than this share of the picture's border is cut off by it. */
const MAX_OF_RIM = 0.12;
/** Alpha below which a pixel is background. */
const CLEAR = 64;

/**
 * Separates the object from the background by its contrast, and keeps its largest piece without holes.
 * @param object the object in the picture, as messages name it: "leaf", "petal", "sepal"
 * @throws TraceError if no object stands out, or the object is cut off by the border
 */
export function silhouetteOf(picture: PixelImage, object: string): Mask {
	const away = differences(picture);
	const threshold = Math.max(LEAST_CONTRAST, otsuThreshold(away));
	const { width, height } = picture;
	const mask: Mask = { width, height, inside: Uint8Array.from(away, (value) => (value > threshold ? 1 : 0)) };
	const largest = fillHoles(largestBlob(mask));
	const size = largest.inside.reduce((sum, value) => sum + value, 0);
	if (size < LEAST_SHARE * width * height) {
		throw new TraceError(text.message("no_object", { object }));
	}
	const rim = rimOf(width, height);
	if (rim.filter((pixel) => largest.inside[pixel]).length > MAX_OF_RIM * rim.length) {
		throw new TraceError(text.message("object_cut_off", { object }));
	}
	return largest;
}

/**
 * Returns each pixel's colour difference from the background, the median colour of the picture's border: 0 … 441.
 * Transparent pixels get 0.
 */
function differences({ width, height, data }: PixelImage): Float32Array {
	const rim = rimOf(width, height).filter((pixel) => data[4 * pixel + 3] >= CLEAR);
	const ground = [0, 1, 2].map((channel) => median(rim.map((pixel) => data[4 * pixel + channel])));
	// With a transparent background, all opaque pixels are foreground.
	const isClear = rim.length < 0.5 * rimOf(width, height).length;
	return Float32Array.from({ length: width * height }, (_, pixel) => {
		if (data[4 * pixel + 3] < CLEAR) return 0;
		if (isClear) return 255;
		return Math.hypot(...ground.map((value, channel) => data[4 * pixel + channel] - value));
	});
}

/** Returns the indices of the pixels along the picture's border; corners are listed twice. */
function rimOf(width: number, height: number): number[] {
	const rows = Array.from({ length: height }, (_, y) => [y * width, y * width + width - 1]).flat();
	const columns = Array.from({ length: width }, (_, x) => [x, (height - 1) * width + x]).flat();
	return [...rows, ...columns];
}

/** The middle one of the values, which are sorted in place; 255 if there are none. */
function median(values: number[]): number {
	return values.sort((a, b) => a - b)[values.length >> 1] ?? 255;
}

/**
 * Returns the threshold that separates values best into two classes: the one with the greatest variance between the
 * classes, over a histogram (Otsu 1979).
 */
function otsuThreshold(values: Float32Array): number {
	const BINS = 256;
	const greatest = values.reduce((best, value) => Math.max(best, value), 1);
	const bins = new Float64Array(BINS);
	for (const value of values) bins[Math.min(BINS - 1, Math.floor((value / greatest) * BINS))]++;
	const total = values.length;
	const sum = bins.reduce((done, count, bin) => done + count * bin, 0);
	let [below, belowSum, best, cut] = [0, 0, -1, 0];
	for (let bin = 0; bin < BINS; bin++) {
		below += bins[bin];
		belowSum += bin * bins[bin];
		if (below === 0 || below === total) continue;
		const meanDifference = belowSum / below - (sum - belowSum) / (total - below);
		const variance = below * (total - below) * meanDifference * meanDifference;
		if (variance > best) [best, cut] = [variance, bin + 1];
	}
	return (cut / BINS) * greatest;
}

/** Returns the largest connected blob; neighbours share a side. */
export function largestBlob({ width, height, inside }: Mask): Mask {
	const blobs = blobsOf({ width, height, inside });
	const members = blobs.reduce((best, blob) => (blob.length > best.length ? blob : best), new Uint32Array(0));
	return maskOf(width, height, members);
}

/** Returns every connected blob of a mask, as pixel indices. */
export function blobsOf({ width, height, inside }: Mask): Uint32Array[] {
	const visited = Uint8Array.from(inside, (value) => 1 - value);
	const queue = new Uint32Array(width * height);
	const blobs: Uint32Array[] = [];
	for (let start = 0; start < visited.length; start++) {
		if (!visited[start]) blobs.push(flood(start, width, visited, queue).slice());
	}
	return blobs;
}

/** Returns the mask of a list of pixel indices. */
export function maskOf(width: number, height: number, members: Uint32Array): Mask {
	const inside = new Uint8Array(width * height);
	for (const pixel of members) inside[pixel] = 1;
	return { width, height, inside };
}

/** Fills the holes of a mask: pixels outside it that no path connects to the border. */
function fillHoles({ width, height, inside }: Mask): Mask {
	const visited = inside.slice();
	const queue = new Uint32Array(width * height);
	for (const pixel of rimOf(width, height)) if (!visited[pixel]) flood(pixel, width, visited, queue);
	return { width, height, inside: Uint8Array.from(inside, (value, pixel) => (value || !visited[pixel] ? 1 : 0)) };
}

/**
 * Marks all pixels connected to an unvisited pixel, and lists them in `queue`.
 * @param visited 1 for visited pixels, changed in place
 * @param queue room for all pixels' indices
 * @returns the part of `queue` with the indices of the newly marked pixels
 */
function flood(start: number, width: number, visited: Uint8Array, queue: Uint32Array): Uint32Array {
	let end = 0;
	queue[end++] = start;
	visited[start] = 1;
	for (let next = 0; next < end; next++) {
		const pixel = queue[next];
		const x = pixel % width;
		const visit = (other: number) => {
			if (visited[other] !== 0) return;
			visited[other] = 1;
			queue[end++] = other;
		};
		if (x > 0) visit(pixel - 1);
		if (x < width - 1) visit(pixel + 1);
		if (pixel >= width) visit(pixel - width);
		if (pixel + width < visited.length) visit(pixel + width);
	}
	return queue.subarray(0, end);
}
