import { execFileSync } from "node:child_process";
import { join } from "node:path";
import type { Page } from "@playwright/test";
import type { Views } from "../views/page";
import { serveUnder } from "./static_server";

declare global {
	interface Window {
		/** On the page of tests/views. */
		views: Views;
	}
}

/** Where this worker has built each page, once for all its tests. */
const folders = new Map<string, string>();

/** Builds the page of a folder of tests/, by default the one that is nothing but views, and serves it. */
export async function serveViews(name = "views"): Promise<{ address: string; close(): Promise<void> }> {
	const folder = folders.get(name) ?? builtHere(name);
	folders.set(name, folder);
	return serveUnder("/", folder);
}

function builtHere(name: string): string {
	// Tests of another worker may use its own build.
	const folder = `build/${name}/${process.env.TEST_PARALLEL_INDEX}`;
	const built = [
		"build",
		"--config",
		`tests/${name}/vite.config.ts`,
		"--outDir",
		join(process.cwd(), folder),
		"--emptyOutDir",
	];
	execFileSync(process.execPath, ["node_modules/vite/bin/vite.js", ...built]);
	return folder;
}

export async function openViews(page: Page, address: string): Promise<void> {
	await page.goto(address);
	await page.waitForFunction(() => "views" in window);
}

/** Options of a small picture. */
export interface PictureOptions {
	/** A bunch as a link has it. */
	query: string;
	theme?: "light" | "dark";
	mode?: string;
	/** Radians by which the plant is turned to the right before. */
	turn?: number;
	/** The index of the berry that is marked. */
	marked?: number;
	/** Pixels each way; 64 where absent. */
	side?: number;
}

/** Means over a small picture, each channel 0 … 255, and where in it things are, 0 … 1 from the left and from the top. */
export interface Seen {
	/** Rows of columns of pixels: red, green, blue. */
	pixels: [red: number, green: number, blue: number][][];
}

/** Draws a small picture with a view of its own. */
export function drawn(page: Page, options: PictureOptions): Promise<Seen> {
	return page.evaluate(async ({ query, theme = "light", mode, turn = 0, marked, side = 64 }) => {
		const { grow, view, pixels } = window.views;
		const viewer = view(query, [side, side], { theme });
		if (mode) viewer.setMode(mode);
		if (turn) viewer.orbit(turn, 0);
		if (marked !== undefined) viewer.mark(grow(query).grown.berries.ids[marked]);
		// Supersampling: drawn larger than a canvas smooths, each pixel is the mean of the pixels that it covers.
		const { data, width } = await pixels(await viewer.snapshot(4 * side, 4 * side));
		viewer.dispose();
		const mean = (row: number, column: number): [number, number, number] => {
			const sum: [number, number, number] = [0, 0, 0];
			for (let y = 4 * row; y < 4 * row + 4; y++) {
				for (let x = 4 * column; x < 4 * column + 4; x++) {
					for (let k = 0; k < 3; k++) sum[k] += data[4 * (y * width + x) + k] / 16;
				}
			}
			return sum;
		};
		const each = Array.from({ length: side }, (_, i) => i);
		return { pixels: each.map((row) => each.map((column) => mean(row, column))) };
	}, options);
}

const luma = ([red, green, blue]: readonly number[]) => 0.2126 * red + 0.7152 * green + 0.0722 * blue;

/** The mean brightness, 0 … 255, of the pixels that `where` holds for: columns and rows as shares of the picture. */
export function brightness(
	{ pixels }: Seen,
	where: (x: number, y: number, pixel: readonly number[]) => boolean,
): number {
	let [sum, count] = [0, 0];
	pixels.forEach((row, r) => {
		row.forEach((pixel, c) => {
			if (!where((c + 0.5) / row.length, (r + 0.5) / pixels.length, pixel)) return;
			sum += luma(pixel);
			count++;
		});
	});
	return count > 0 ? sum / count : Number.NaN;
}

/** The mean share from the left of the pixels in which two pictures differ by more than `least`. */
export function whereTheyDiffer(one: Seen, other: Seen, least = 12): { x: number; y: number; count: number } {
	let [x, y, count] = [0, 0, 0];
	one.pixels.forEach((row, r) => {
		row.forEach((pixel, c) => {
			if (Math.abs(luma(pixel) - luma(other.pixels[r][c])) < least) return;
			x += (c + 0.5) / row.length;
			y += (r + 0.5) / one.pixels.length;
			count++;
		});
	});
	return { x: x / count, y: y / count, count };
}
