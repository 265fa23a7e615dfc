import type { Page } from "@playwright/test";

/** Returns the ages that the slider shows from now on until 100 %, each once, in their order. */
export const agesUntilGrown = (page: Page): Promise<string[]> =>
	page.evaluate(
		() =>
			new Promise<string[]>((resolve) => {
				const values = new Set<string>();
				const look = () => {
					values.add(document.querySelector<HTMLInputElement>("panicle-life input[type=range]")?.value ?? "");
					if (values.has("100")) resolve([...values]);
					else requestAnimationFrame(look);
				};
				look();
			}),
	);
