/**
 * `specimens.js`, for pages of one's own in the app's folder or below it: `await ready`, and addresses of specimens are answered in the
 * browser, by the app's service worker. docs/service.md has examples.
 */
import { registerWorker, tellOpened } from "./register";
import { hostSpecimens } from "./specimen_host";

/** Settles when this page's requests go by the worker; rejects where they never will, and says why. */
export const ready: Promise<void> = start();

async function start(): Promise<void> {
	// The built script lies in the app's folder itself.
	const folder = new URL(/* @vite-ignore */ "./", import.meta.url);
	if (!location.href.startsWith(folder.href))
		throw new Error(`Only pages below ${folder.href} are answered by its service worker.`);
	const registration = await registerWorker(folder);
	if (!registration) throw new Error("There is no service worker here that could grow specimens.");
	hostSpecimens();
	if (navigator.serviceWorker.controller) return;
	const controlled = new Promise<void>((resolve) => {
		navigator.serviceWorker.addEventListener("controllerchange", () => resolve(), { once: true });
	});
	// A first worker takes its pages by itself, and one that is there already when it is told of them.
	tellOpened(await navigator.serviceWorker.ready, false);
	await controlled;
}
