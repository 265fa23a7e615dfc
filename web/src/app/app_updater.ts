/** The app without a network, and its next version: what the page does of docs/offline.md. */
import { holdScripts } from "../core/hold_scripts";
import type { ToWorker } from "../offline/messages";
import { forgetWorker, registerWorker, tellOpened } from "../offline/register";
import { hostSpecimens } from "../offline/specimen_host";

/** A page that stays open asks for a new version when it is turned to, so often at the most; milliseconds. */
const CHECK_INTERVAL = 3_600_000;
/** A worker that has come and nothing to wait for has begun after this; milliseconds. */
const ACTIVATION_TIME = 1000;

/** The page's main script, which no two versions share. */
const mainScript = (): string => document.querySelector<HTMLScriptElement>("script[type=module]")?.src ?? "";
const folder = () => new URL("./", document.baseURI);

export class AppUpdater {
	readonly #offer: (reload: () => void) => void;
	#registration: ServiceWorkerRegistration | undefined;
	#lastCheck = Date.now();
	#looking = false;

	/** @param offer says that there is a new version, and how to go over to it: the page is loaded again */
	constructor(offer: (reload: () => void) => void) {
		this.#offer = offer;
		holdScripts(mainScript());
	}

	/** Registers the worker and has it keep the app. Rejects where that fails: then the app is what it was without. */
	async start(): Promise<void> {
		await new Promise((resolve) =>
			"requestIdleCallback" in window ? requestIdleCallback(resolve) : setTimeout(resolve),
		);
		const registration = await registerWorker(folder());
		if (!registration) return;
		this.#registration = registration;
		hostSpecimens();
		registration.addEventListener("updatefound", () => void this.#follow());
		void this.#follow();
		document.addEventListener("visibilitychange", () => this.#checkForUpdate());
		await navigator.serviceWorker.ready;
		// Who asks to be spared data has the app kept when that no longer holds.
		const { connection } = navigator as { connection?: { saveData?: boolean } };
		tellOpened(registration, !connection?.saveData);
		// A host whose next version cannot be kept must not be left with this one for ever.
		if (navigator.serviceWorker.controller) await this.look();
	}

	/**
	 * Whether the host has another version by now, which is offered: where part of the page did not come, it never will. Asked again
	 * while it looks, it looks once.
	 */
	async look(): Promise<void> {
		if (this.#looking || !navigator.onLine) return;
		this.#looking = true;
		try {
			const page = await fetch(folder(), { cache: "no-store" });
			if (!page.ok || (await page.text()).includes(new URL(mainScript()).pathname.split("/").at(-1) as string)) return;
			// Where the worker keeps the page, it is the worker that brings the new one.
			await this.#registration?.update().catch(() => {});
			await this.#follow();
			if (!this.#registration?.waiting) this.#offer(() => void this.#reloadFromHost());
		} catch {
			// There is no network, and what could not be fetched has been told of.
		} finally {
			this.#looking = false;
		}
	}

	/** Waits for the version that comes, and offers it where it waits for its turn. */
	async #follow(): Promise<void> {
		const { installing, waiting, active } = this.#registration ?? {};
		if (installing) await installed(installing);
		const next = installing ?? waiting;
		if (!active || !next) return; // The first is no new one.
		await new Promise((resolve) => setTimeout(resolve, ACTIVATION_TIME));
		if (this.#registration?.waiting === next) this.#offer(() => this.#switchToWaiting());
	}

	#checkForUpdate(): void {
		if (document.hidden || Date.now() - this.#lastCheck < CHECK_INTERVAL) return;
		this.#lastCheck = Date.now();
		this.#registration?.update().catch(() => {}); // Without a network there is none.
	}

	/** To the version that waits, unless another tab has gone over to it already. */
	#switchToWaiting(): void {
		const waiting = this.#registration?.waiting;
		if (waiting) {
			navigator.serviceWorker.addEventListener("controllerchange", () => location.reload(), { once: true });
			waiting.postMessage({ type: "take over" } satisfies ToWorker);
		} else location.reload();
	}

	/** To the host's version, which is not kept: what is would come again. */
	async #reloadFromHost(): Promise<void> {
		if (this.#registration) await forgetWorker(this.#registration).catch(() => {});
		location.reload();
	}
}

/** Settles when a worker has all it needs, or has failed. */
function installed(worker: ServiceWorker): Promise<void> {
	return new Promise((resolve) => {
		const look = () => {
			if (worker.state !== "installing") resolve();
		};
		worker.addEventListener("statechange", look);
		look();
	});
}
