/** Messages between pages and the service worker. */

/** From a page. */
export type ToServiceWorker =
	/** A page is open; `keep`: cache the whole app for use without a network. */
	| { readonly type: "opened"; readonly keep: boolean }
	/** The user has chosen to use the new version. */
	| { readonly type: "take over" };

/**
 * Sent to every page: a specimen is needed. A page that can grow specimens answers `FREE` on the port sent with the
 * message, and receives the request there.
 */
export const GROWTH_NEEDED = "panicle specimen";
export const FREE = "free";
/** Sent by the service worker on that port after the request: the answer is no longer needed. */
export const CANCEL = "cancel";

/** A request for a specimen's file, with the addresses of the scripts and cores that grow it. */
export interface SpecimenRequest {
	readonly url: string;
	readonly method: string;
	readonly headers: Readonly<Record<string, string>>;
	/** Address of the script that serves specimens (specimens.ts). */
	readonly script: string;
	/** Addresses of the cores by file name: `tree.wasm`. */
	readonly cores: Readonly<Record<string, string>>;
	readonly release: string;
}

export type SpecimenAnswer =
	| {
			readonly type: "answer";
			readonly status: number;
			readonly headers: Readonly<Record<string, string>>;
			readonly body: Uint8Array<ArrayBuffer>;
	  }
	/** The page's worker could not be started, or failed. */
	| { readonly type: "unable" };

/** The most waiting requests in a page, and in the service worker. */
export const MAX_WAITING = 16;

/** Returns a response of status 503 with its reason. */
export function refusal(message: string): Extract<SpecimenAnswer, { type: "answer" }> {
	const headers = {
		"content-type": "text/plain; charset=utf-8",
		"cache-control": "no-store",
		"retry-after": "5",
		"access-control-allow-origin": "*",
	};
	return { type: "answer", status: 503, headers, body: new TextEncoder().encode(`${message}\n`) };
}
