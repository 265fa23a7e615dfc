import { test as base, expect, type Page } from "@playwright/test";
import { withoutDrawing } from "./without_drawing.mjs";
import { withoutHints } from "./without_hints.mjs";

/** Errors of a page, and the errors that a test expects. */
export class Complaints {
	readonly #heard: string[] = [];
	readonly #expected: RegExp[] = [];

	/** Complaints that match are no failure of this test. */
	expect(pattern: RegExp): void {
		this.#expected.push(pattern);
	}

	/** Listens to another page, for tests that open more than one. */
	listenTo(page: Page): void {
		page.on("console", (message) => {
			if (message.type() === "error") this.#heard.push(`console: ${message.text()} (${message.location().url})`);
		});
		page.on("pageerror", (error) => this.#heard.push(`uncaught: ${error.message}`));
		page.on("requestfailed", (request) => {
			const reason = request.failure()?.errorText ?? "";
			// A page that is left drops its requests; so does a worker that is ended.
			if (reason !== "net::ERR_ABORTED") this.#heard.push(`request: ${request.url()} ${reason}`);
		});
		page.on("response", (response) => {
			if (response.status() >= 400) this.#heard.push(`response: ${response.status()} ${response.url()}`);
		});
	}

	/** Errors that were not expected. */
	unexpected(): string[] {
		return this.#heard.filter((complaint) => !this.#expected.some((pattern) => pattern.test(complaint)));
	}
}

interface Fixtures {
	complaints: Complaints;
	/** Whether pages draw: `test.use({ drawn: true })` for tests that check the 3-D picture. */
	drawn: boolean;
	/** Whether pages show the hints of a first visit: `test.use({ hints: true })` for tests of the hints. */
	hints: boolean;
}

/**
 * Playwright's `test`, failing when the page complains: errors in the console, uncaught errors, failed requests. Pages do all
 * but draw in 3-D, which by software costs more than all else, unless `drawn`.
 */
export const test = base.extend<Fixtures>({
	drawn: [false, { option: true }],
	hints: [false, { option: true }],
	context: async ({ context, drawn, hints }, use) => {
		if (!hints) await context.addInitScript(withoutHints);
		if (!drawn) await context.addInitScript(withoutDrawing);
		await use(context);
	},
	complaints: [
		async ({ page }, use) => {
			const complaints = new Complaints();
			complaints.listenTo(page);
			await use(complaints);
			expect(complaints.unexpected(), "what the page complained of").toEqual([]);
		},
		{ auto: true },
	],
});

export { expect };
