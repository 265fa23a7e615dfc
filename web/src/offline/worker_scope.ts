import type { PageClient } from "./page_growth";

/** The part of a service worker's scope that is used here; the page's types do not describe it. */
interface Lasting extends Event {
	/** Keeps the worker alive until the promise settles; a rejection is a failure of the event. */
	waitUntil(work: Promise<unknown>): void;
}

interface Fetching extends Lasting {
	readonly request: Request;
	respondWith(answer: Promise<Response>): void;
}

interface MessageReceived extends Lasting {
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
	addEventListener(type: "message", listener: (event: MessageReceived) => void): void;
}
