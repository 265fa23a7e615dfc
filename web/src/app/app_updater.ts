/** Registers the service worker and offers new versions of the app: the page's side of docs/offline.md. */
import { holdScripts } from "../core/hold_scripts";
import type { ToServiceWorker } from "../offline/messages";
import { forgetWorker, registerWorker, reportOpened } from "../offline/register";
import { hostSpecimens } from "../offline/specimen_host";

/** Least time between two checks for a new version, each made when an open page becomes visible; milliseconds. */
const CHECK_INTERVAL = 3_600_000;
/** Time within which an installed worker becomes active if no open page holds it back; milliseconds. */
const ACTIVATION_TIME = 1000;

/** Longest wait for an idle moment before the app is stored, for pages that never rest; milliseconds. */
const LONGEST_IDLE_WAIT = 5000;

/** Returns the address of the page's main script, which differs in every version. */
const mainScript = (): string => document.querySelector<HTMLScriptElement>("script[type=module]")?.src ?? "";
/** Returns the address of the app's folder. */
const appFolder = () => new URL("./", document.baseURI);

export class AppUpdater {
	readonly #offer: (reload: () => void) => void;
	#registration: ServiceWorkerRegistration | undefined;
	#lastCheck = Date.now();
	#looking = false;

	/** @param offer shows that a new version is available; `reload` loads the page in that version */
	constructor(offer: (reload: () => void) => void) {
		this.#offer = offer;
		holdScripts(mainScript());
	}

	/**
	 * Registers the service worker, which stores the app for offline use. Rejects where that fails: the app then works
	 * online only.
	 */
	async start(): Promise<void> {
		await new Promise((resolve) =>
			"requestIdleCallback" in window
				? requestIdleCallback(resolve, { timeout: LONGEST_IDLE_WAIT })
				: setTimeout(resolve),
		);
		const registration = await registerWorker(appFolder());
		if (!registration) return;
		this.#registration = registration;
		hostSpecimens();
		registration.addEventListener("updatefound", () => void this.#follow());
		void this.#follow();
		document.addEventListener("visibilitychange", () => this.#checkForUpdate());
		await navigator.serviceWorker.ready;
		// With the browser's data saver on, the app is not stored.
		const { connection } = navigator as { connection?: { saveData?: boolean } };
		reportOpened(registration, !connection?.saveData);
		// Check the host directly: where the worker cannot store the next version, it would serve this one permanently.
		if (navigator.serviceWorker.controller) await this.look();
	}

	/**
	 * Checks whether the host has another version by now, and offers it. A script that could not be fetched may belong to
	 * a version that the host no longer has. Calls during a check are ignored.
	 */
	async look(): Promise<void> {
		if (this.#looking || !navigator.onLine) return;
		this.#looking = true;
		try {
			const page = await fetch(appFolder(), { cache: "no-store" });
			if (!page.ok || (await page.text()).includes(new URL(mainScript()).pathname.split("/").at(-1) as string)) return;
			// Where a worker serves the page, the worker fetches the new version.
			await this.#registration?.update().catch(() => {});
			await this.#follow();
			if (!this.#registration?.waiting) this.#offer(() => void this.#reloadFromHost());
		} catch {
			// No network: the failed fetch has been reported already.
		} finally {
			this.#looking = false;
		}
	}

	/** Waits until the new worker is installed, and offers it if it then waits to become active. */
	async #follow(): Promise<void> {
		const { installing, waiting, active } = this.#registration ?? {};
		if (installing) await untilInstalled(installing);
		const next = installing ?? waiting;
		if (!active || !next) return; // The first worker is no update.
		await new Promise((resolve) => setTimeout(resolve, ACTIVATION_TIME));
		if (this.#registration?.waiting === next) this.#offer(() => this.#switchToWaiting());
	}

	/** Looks for a new version, at most once per interval and only while the page is visible. */
	#checkForUpdate(): void {
		if (document.hidden || Date.now() - this.#lastCheck < CHECK_INTERVAL) return;
		this.#lastCheck = Date.now();
		this.#registration?.update().catch(() => {}); // Without a network there is no update.
	}

	/** Reloads the page in the waiting version; if another tab has activated it already, reloads at once. */
	#switchToWaiting(): void {
		const waiting = this.#registration?.waiting;
		if (waiting) {
			navigator.serviceWorker.addEventListener("controllerchange", () => location.reload(), { once: true });
			waiting.postMessage({ type: "take over" } satisfies ToServiceWorker);
		} else location.reload();
	}

	/** Reloads the page from the host. Unregisters the worker first, which would serve its stored version again. */
	async #reloadFromHost(): Promise<void> {
		if (this.#registration) await forgetWorker(this.#registration).catch(() => {});
		location.reload();
	}
}

/** Resolves when a worker has finished installing, or has failed. */
function untilInstalled(worker: ServiceWorker): Promise<void> {
	return new Promise((resolve) => {
		const check = () => {
			if (worker.state !== "installing") resolve();
		};
		worker.addEventListener("statechange", check);
		check();
	});
}
