/** The service worker, as pages meet it. */
import type { ToWorker } from "./messages";

const SCRIPT = "service-worker.js";

/**
 * Registers the app's worker for the app's folder; whoever calls it again has the same one. A host that has a worker of its own in that
 * place keeps it, and where the script is gone, the host wants none: what there was of it is cleared away.
 *
 * @param folder the app's, an address that ends in a slash
 * @returns undefined where there is to be no worker, or can be none
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
	// Past the browser's keep: or a new version would be noticed when that forgets the old script.
	return navigator.serviceWorker.register(href, { updateViaCache: "none" });
}

/** Tells the worker that a page is open. */
export function tellOpened({ active }: ServiceWorkerRegistration, keep: boolean): void {
	active?.postMessage({ type: "opened", keep } satisfies ToWorker);
}

async function isGone(script: string): Promise<boolean> {
	try {
		const { status } = await fetch(script, { method: "HEAD", cache: "no-store" });
		return status === 404 || status === 410;
	} catch {
		return false; // The host is out of reach, which is what the worker is for.
	}
}

/** Clears away a worker and what it kept: the next page comes from the host. */
export async function forgetWorker(registration: ServiceWorkerRegistration): Promise<void> {
	const names = await caches.keys();
	const own = names.filter((name) => name.startsWith(`panicle ${registration.scope} `));
	await Promise.all(own.map((name) => caches.delete(name)));
	await registration.unregister();
}
