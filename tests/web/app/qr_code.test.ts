import decodeQR from "qr/decode.js";
import { describe, expect, it } from "vitest";
import { LONGEST_QR_LINK, type QrModules, qrModules, qrPath, qrPng, qrSvg } from "../../../web/src/app/files/qr_code";
import { png } from "../../../web/src/formats/png";

const LINK = "https://plants.example/?v=2&model=flower&preset=tulip&seed=7";

function modulesOf(link: string): QrModules {
	const modules = qrModules(link);
	if (!modules) throw new Error("The link is too long.");
	return modules;
}

/** The modules that a path paints, drawn on a picture of `scale` pixels per module. */
function painted(path: string, size: number, scale = 4): { width: number; height: number; data: Uint8Array } {
	const width = size * scale;
	const data = new Uint8Array(3 * width * width).fill(255);
	for (const [, x, y, length] of path.matchAll(/M(\d+) (\d+)h(\d+)v1h-\3z/g)) {
		const [left, top, wide] = [Number(x) * scale, Number(y) * scale, Number(length) * scale];
		for (let row = top; row < top + scale; row++)
			data.fill(0, 3 * (row * width + left), 3 * (row * width + left + wide));
	}
	return { width, height: width, data };
}

describe("the QR code of a link", () => {
	it.each([LINK, `${LINK}#g=${"aB3_".repeat(100)}`, `${LINK}&`.padEnd(LONGEST_QR_LINK, "x")])(
		"is read back, from the path that is drawn",
		(link) => {
			const modules = modulesOf(link);
			expect(decodeQR(painted(qrPath(modules), modules.length))).toBe(link);
		},
	);

	it("has an empty margin of four modules", () => {
		const modules = modulesOf(LINK);
		for (const edge of [0, 1, 2, 3]) {
			expect(modules[edge].every((dark) => !dark)).toBe(true);
			expect(modules.every((row) => !row[edge] && !row[row.length - 1 - edge])).toBe(true);
		}
		expect(modules[4][4]).toBe(true);
	});

	it("is undefined for links that are too long", () => {
		expect(qrModules("x".repeat(LONGEST_QR_LINK))).toBeDefined();
		expect(qrModules("x".repeat(LONGEST_QR_LINK + 1))).toBeUndefined();
	});

	it("is saved as an SVG with the same path", async () => {
		const modules = modulesOf(LINK);
		const svg = qrSvg(modules);
		expect(svg.type).toBe("image/svg+xml");
		expect(await svg.text()).toContain(`<path d="${qrPath(modules)}"/>`);
	});

	it("is saved as a PNG with whole pixels per module", async () => {
		const modules = modulesOf(LINK);
		const size = modules.length;
		const scale = Math.ceil(1024 / size);
		const { width, data } = painted(qrPath(modules), size, scale);
		const expected = png({ width, height: width, pixels: data });
		expect(new Uint8Array(await qrPng(modules).arrayBuffer())).toEqual(expected);
	});
});
