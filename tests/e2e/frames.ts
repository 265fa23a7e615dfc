/** Counts animation frames of a page, to measure rest and movement independently of the machine's speed. */
import type { Page } from "@playwright/test";

/** Waits until the browser has drawn so many frames. */
export const passFrames = (page: Page, count: number): Promise<void> =>
	page.evaluate(async (frames) => {
		for (let i = 0; i < frames; i++) await new Promise(requestAnimationFrame);
	}, count);

/** How many animation frames the page requests while the browser draws twenty: about twenty while something moves, none at rest. */
export const framesRequested = (page: Page): Promise<number> =>
	page.evaluate(async () => {
		let requested = 0;
		const request = window.requestAnimationFrame;
		window.requestAnimationFrame = (callback) => {
			requested++;
			return request.call(window, callback);
		};
		for (let i = 0; i < 20; i++) await new Promise((resolve) => request.call(window, resolve));
		window.requestAnimationFrame = request;
		return requested;
	});
