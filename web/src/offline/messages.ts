/** What pages say to the service worker, and it to them. */

/** From a page. */
export type ToWorker =
	/** A page is open; `keep`: the whole app is to be there without a network from now on. */
	| { readonly type: "opened"; readonly keep: boolean }
	/** A person has asked for the new version. */
	| { readonly type: "take over" };

/** To every page: a specimen is to be grown. A page that grows them answers `FREE` on the port that comes with it, and gets the request there. */
export const GROWTH_NEEDED = "panicle specimen";
export const FREE = "free";

/** A request for a specimen's file, and what its growth needs of the build. */
export interface SpecimenRequest {
	readonly url: string;
	readonly method: string;
	readonly headers: Readonly<Record<string, string>>;
	/** Address of the script that answers (specimens.ts). */
	readonly script: string;
	/** Addresses of the cores by what models call them. */
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
	/** The page's worker could not be started. */
	| { readonly type: "unable" };

/** Requests that wait in one place at the most. */
export const MOST_WAITING = 16;
export const TOO_MANY = "too many ask at once; try again in a moment";

/** An answer in words. */
export function refusal(message: string): Extract<SpecimenAnswer, { type: "answer" }> {
	const headers = {
		"content-type": "text/plain; charset=utf-8",
		"cache-control": "no-store",
		"retry-after": "5",
		"access-control-allow-origin": "*",
	};
	return { type: "answer", status: 503, headers, body: new TextEncoder().encode(`${message}\n`) };
}
