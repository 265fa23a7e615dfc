/** Finds the silhouette of one object on a plain background, without holes. */
import { type Mask, type PixelImage, TraceError } from "./picture";

/** Least colour difference from the background that counts as foreground, 0 … 441. */
const LEAST_CONTRAST = 26;
/** Least area of a silhouette, as a share of the picture. */
const LEAST_SHARE = 0.005;
/** A silhouette that covers more than this share of the picture's border is cut off by it. */
const MOST_OF_RIM = 0.12;
/** Alpha below which a pixel is background. */
const CLEAR = 64;

/**
 * @param noun name of the object in messages: "leaf"
 * @throws TraceError if no object stands out, or the object is cut off by the border
 */
export function silhouetteOf(picture: PixelImage, noun: string): Mask {
	const away = differences(picture);
	const threshold = Math.max(LEAST_CONTRAST, between(away));
	const { width, height } = picture;
	const mask: Mask = { width, height, inside: Uint8Array.from(away, (value) => (value > threshold ? 1 : 0)) };
	const largest = filled(largestBlob(mask));
	const size = largest.inside.reduce((sum, value) => sum + value, 0);
	if (size < LEAST_SHARE * width * height) {
		throw new TraceError(
			`No ${noun} stands out. Take a picture of one ${noun} on a plain ground, much lighter or darker than it.`,
		);
	}
	const rim = rimOf(width, height);
	if (rim.filter((at) => largest.inside[at]).length > MOST_OF_RIM * rim.length) {
		throw new TraceError(
			`The ${noun} runs out of the picture, or the ground is not plain. Leave some ground all round the ${noun}.`,
		);
	}
	return largest;
}

/** Returns each pixel's colour difference from the picture's border. */
function differences({ width, height, data }: PixelImage): Float32Array {
	const rim = rimOf(width, height).filter((at) => data[4 * at + 3] >= CLEAR);
	const ground = [0, 1, 2].map((channel) => median(rim.map((at) => data[4 * at + channel])));
	// With a transparent background, all opaque pixels are foreground.
	const isClear = rim.length < 0.5 * rimOf(width, height).length;
	return Float32Array.from({ length: width * height }, (_, at) => {
		if (data[4 * at + 3] < CLEAR) return 0;
		if (isClear) return 255;
		return Math.hypot(...ground.map((value, channel) => data[4 * at + channel] - value));
	});
}

function rimOf(width: number, height: number): number[] {
	const rows = Array.from({ length: height }, (_, y) => [y * width, y * width + width - 1]).flat();
	const columns = Array.from({ length: width }, (_, x) => [x, (height - 1) * width + x]).flat();
	return [...rows, ...columns];
}

function median(values: number[]): number {
	return values.sort((a, b) => a - b)[values.length >> 1] ?? 255;
}

/** Returns the threshold that separates values best into two classes (Otsu 1979). */
function between(values: Float32Array): number {
	const BINS = 256;
	const most = values.reduce((best, value) => Math.max(best, value), 1);
	const bins = new Float64Array(BINS);
	for (const value of values) bins[Math.min(BINS - 1, Math.floor((value / most) * BINS))]++;
	const total = values.length;
	const sum = bins.reduce((done, count, bin) => done + count * bin, 0);
	let [below, belowSum, best, cut] = [0, 0, -1, 0];
	for (let bin = 0; bin < BINS; bin++) {
		below += bins[bin];
		belowSum += bin * bins[bin];
		if (below === 0 || below === total) continue;
		const apart = belowSum / below - (sum - belowSum) / (total - below);
		const variance = below * (total - below) * apart * apart;
		if (variance > best) [best, cut] = [variance, bin + 1];
	}
	return (cut / BINS) * most;
}

/** Returns the largest connected blob; neighbours share a side. */
export function largestBlob({ width, height, inside }: Mask): Mask {
	const blobs = blobsOf({ width, height, inside });
	const members = blobs.reduce((best, blob) => (blob.length > best.length ? blob : best), new Uint32Array(0));
	return maskOf(width, height, members);
}

/** Returns every connected blob of a mask, as pixel indices. */
export function blobsOf({ width, height, inside }: Mask): Uint32Array[] {
	const seen = Uint8Array.from(inside, (value) => 1 - value);
	const queue = new Uint32Array(width * height);
	const blobs: Uint32Array[] = [];
	for (let start = 0; start < seen.length; start++) {
		if (!seen[start]) blobs.push(flood(start, width, seen, queue).slice());
	}
	return blobs;
}

export function maskOf(width: number, height: number, members: Uint32Array): Mask {
	const inside = new Uint8Array(width * height);
	for (const at of members) inside[at] = 1;
	return { width, height, inside };
}

/** Fills the holes of a mask. */
function filled({ width, height, inside }: Mask): Mask {
	const seen = inside.slice();
	const queue = new Uint32Array(width * height);
	for (const at of rimOf(width, height)) if (!seen[at]) flood(at, width, seen, queue);
	return { width, height, inside: Uint8Array.from(inside, (value, at) => (value || !seen[at] ? 1 : 0)) };
}

/**
 * Marks all pixels connected to an unvisited pixel.
 * @returns a view of `queue`
 */
function flood(start: number, width: number, seen: Uint8Array, queue: Uint32Array): Uint32Array {
	let end = 0;
	queue[end++] = start;
	seen[start] = 1;
	for (let next = 0; next < end; next++) {
		const at = queue[next];
		const x = at % width;
		const visit = (other: number) => {
			if (seen[other] !== 0) return;
			seen[other] = 1;
			queue[end++] = other;
		};
		if (x > 0) visit(at - 1);
		if (x < width - 1) visit(at + 1);
		if (at >= width) visit(at - width);
		if (at + width < seen.length) visit(at + width);
	}
	return queue.subarray(0, end);
}
