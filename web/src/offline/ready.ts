/**
 * `specimens.js`, for other pages in the app's folder or below it: after `await ready`, the app's service worker
 * answers requests for specimens in the browser. docs/service.md has examples.
 */
import { text } from "./messages.generated";
import { registerWorker, reportOpened } from "./register";
import { hostSpecimens } from "./specimen_host";

/** Settles when the worker answers this page's requests; rejects with the reason where it never will. */
export const ready: Promise<void> = start();

/** Registers the service worker and waits until it controls this page. */
async function start(): Promise<void> {
	// The built script is in the app's folder itself.
	const folder = new URL(/* @vite-ignore */ "./", import.meta.url);
	if (!location.href.startsWith(folder.href)) throw new Error(text("elsewhere", { folder: folder.href }));
	const registration = await registerWorker(folder);
	if (!registration) throw new Error(text("no_worker"));
	hostSpecimens();
	if (navigator.serviceWorker.controller) return;
	const controlled = new Promise<void>((resolve) => {
		navigator.serviceWorker.addEventListener("controllerchange", () => resolve(), { once: true });
	});
	// A first worker claims its pages by itself, an existing one when a page reports to it.
	reportOpened(await navigator.serviceWorker.ready, false);
	await controlled;
}
