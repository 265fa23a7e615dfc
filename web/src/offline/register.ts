/** Registers and removes the service worker, for pages. */
import type { ToServiceWorker } from "./messages";

const SCRIPT = "service-worker.js";

/**
 * Registers the app's worker for the app's folder; repeated calls return the same one. The worker of another script at
 * that place stays. Where the host has no script any more, the worker and its caches are removed.
 * @param folder the app's folder, an address that ends in a slash
 * @returns undefined where there is no worker, or none is possible
 */
export async function registerWorker(folder: URL): Promise<ServiceWorkerRegistration | undefined> {
	if (!("serviceWorker" in navigator) || !folder.protocol.startsWith("http")) return undefined;
	const { href } = new URL(SCRIPT, folder);
	const found = await navigator.serviceWorker.getRegistration(folder);
	const before = found?.scope === folder.href ? found : undefined;
	const worker = before?.active ?? before?.waiting ?? before?.installing;
	if (worker && worker.scriptURL !== href) return undefined;
	if (before && navigator.onLine && (await isGone(href))) {
		await forgetWorker(before);
		return undefined;
	}
	// Bypass the browser's cache, which would delay new versions.
	return navigator.serviceWorker.register(href, { updateViaCache: "none" });
}

/** Reports an open page to the worker. */
export function reportOpened({ active }: ServiceWorkerRegistration, keep: boolean): void {
	active?.postMessage({ type: "opened", keep } satisfies ToServiceWorker);
}

/** Returns whether the host has no such script any more; false where the host cannot be reached. */
async function isGone(script: string): Promise<boolean> {
	try {
		const { status } = await fetch(script, { method: "HEAD", cache: "no-store" });
		return status === 404 || status === 410;
	} catch {
		return false; // The host cannot be reached: the worker is for this case.
	}
}

/** Removes a worker and its caches: the next page comes from the host. */
export async function forgetWorker(registration: ServiceWorkerRegistration): Promise<void> {
	const names = await caches.keys();
	const own = names.filter((name) => name.startsWith(`panicle ${registration.scope} `));
	await Promise.all(own.map((name) => caches.delete(name)));
	await registration.unregister();
}
