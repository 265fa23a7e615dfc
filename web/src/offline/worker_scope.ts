import type { PageClient } from "./page_growth";

/** What is used of a service worker's surroundings: the page's types, which hold everywhere else here, do not have them. */
interface Lasting extends Event {
	/** Until then the browser lets the worker live; rejected, what was begun has failed. */
	waitUntil(work: Promise<unknown>): void;
}

interface Fetching extends Lasting {
	readonly request: Request;
	respondWith(answer: Promise<Response>): void;
}

interface Told extends Lasting {
	readonly data: unknown;
}

export interface WorkerScope {
	readonly registration: ServiceWorkerRegistration;
	readonly clients: {
		claim(): Promise<void>;
		matchAll(options: { type: "window" }): Promise<readonly PageClient[]>;
	};
	skipWaiting(): Promise<void>;
	importScripts(...addresses: string[]): void;
	addEventListener(type: "install" | "activate", listener: (event: Lasting) => void): void;
	addEventListener(type: "fetch", listener: (event: Fetching) => void): void;
	addEventListener(type: "message", listener: (event: Told) => void): void;
}
