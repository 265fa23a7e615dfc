/** QR codes (ISO/IEC 18004) of links, as SVG and PNG. */
import encodeQR from "qr";
import { png } from "../../formats/png";

/** Longest link, in characters: version 25 of 40. The modules of larger codes are too small for a phone's camera. */
export const LONGEST_QR_LINK = 1273;
/** Links up to this length get the error correction *medium*, which allows for dirt and wear in print. */
const LONGEST_MEDIUM = 400;
/** The empty margin that the standard requires, in modules. */
const MARGIN = 4;
/** Least width of the PNG, in pixels. */
const PNG_WIDTH = 1024;

/** The modules of a QR code, in rows from the top, with its margin: true is dark. */
export type QrModules = readonly (readonly boolean[])[];

/** Encodes a link; undefined if it is longer than LONGEST_QR_LINK. */
export function qrModules(link: string): QrModules | undefined {
	if (new TextEncoder().encode(link).length > LONGEST_QR_LINK) return undefined;
	return encodeQR(link, "raw", { ecc: link.length > LONGEST_MEDIUM ? "low" : "medium", border: MARGIN });
}

/** Returns the dark modules as an SVG path: a rectangle for each run of a row. */
export function qrPath(modules: QrModules): string {
	return modules
		.flatMap((row, y) => darkRuns(row).map(({ start, length }) => `M${start} ${y}h${length}v1h-${length}z`))
		.join("");
}

/** Returns the runs of dark modules of a row, each by its first module and its length. */
function darkRuns(row: readonly boolean[]): { start: number; length: number }[] {
	const runs: { start: number; length: number }[] = [];
	for (let start = row.indexOf(true); start >= 0; ) {
		const light = row.indexOf(false, start);
		const end = light < 0 ? row.length : light;
		runs.push({ start, length: end - start });
		start = row.indexOf(true, end);
	}
	return runs;
}

/** Returns the code as an SVG file, black on white. */
export function qrSvg(modules: QrModules): Blob {
	const size = modules.length;
	const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${size} ${size}" shape-rendering="crispEdges"><path fill="#fff" d="M0 0h${size}v${size}H0z"/><path d="${qrPath(modules)}"/></svg>\n`;
	return new Blob([svg], { type: "image/svg+xml" });
}

/** Returns the code as a PNG file, black on white, with whole pixels per module. */
export function qrPng(modules: QrModules): Blob {
	const scale = Math.ceil(PNG_WIDTH / modules.length);
	const width = scale * modules.length;
	const pixels = new Uint8Array(3 * width * width);
	for (let y = 0; y < width; y++) {
		const row = modules[Math.floor(y / scale)];
		for (let x = 0; x < width; x++) {
			if (!row[Math.floor(x / scale)]) pixels.fill(255, 3 * (y * width + x), 3 * (y * width + x) + 3);
		}
	}
	return new Blob([png({ width, height: width, pixels })], { type: "image/png" });
}
