/** Pages of other origins that show plants by `<panicle-specimen>`, as its users have them. */
import type { Page } from "@playwright/test";
import type { PanicleSpecimen } from "../../web/src/element/panicle";
import { type HostPage, serveUnder } from "./static_server";

/** Where the library lies. */
export const serveLibrary = () => serveUnder("/of/panicle/");

export const SMALL = 'preset="redcurrant" count="6"';

/** Opens a page of another origin that has the library's script. */
export async function openHost(
	page: Page,
	library: string,
	body: string,
	policy?: string,
): Promise<() => Promise<void>> {
	const html = `<!doctype html><html lang="en"><title>Plants</title><link rel="icon" href="data:,"><script type="module" src="${library}panicle.js"></script>${body}`;
	const pages: Record<string, HostPage> = { "plants.html": { html, ...(policy ? { policy } : {}) } };
	const host = await serveUnder("/none/", "dist", pages);
	await page.goto(new URL("/plants.html", host.address).href);
	return host.close;
}

/** Waits until every plant of the page has grown. */
export async function grown(page: Page): Promise<void> {
	await page.waitForFunction(() =>
		[...document.querySelectorAll<PanicleSpecimen>("panicle-specimen")].every(
			(each) => each.plant && !each.hasAttribute("aria-busy"),
		),
	);
}
