import type { Page } from "@playwright/test";

/** A PNG of 200 × 240 for tracing: a green ellipse, 100 wide and 160 tall, on a stalk. */
export async function drawnBlade(page: Page): Promise<Buffer> {
	const bytes = await page.evaluate(async () => {
		const canvas = new OffscreenCanvas(200, 240);
		const pen = canvas.getContext("2d") as OffscreenCanvasRenderingContext2D;
		pen.fillStyle = "#eee";
		pen.fillRect(0, 0, 200, 240);
		pen.fillStyle = "#376b2a";
		pen.beginPath();
		pen.ellipse(100, 100, 50, 80, 0, 0, 7);
		pen.fill();
		pen.fillRect(98, 170, 4, 60);
		return [...new Uint8Array(await (await canvas.convertToBlob({ type: "image/png" })).arrayBuffer())];
	});
	return Buffer.from(bytes);
}
