/** What pages say to the service worker. */
export type ToWorker =
	/** A page is open; `keep`: the whole app is to be there without a network from now on. */
	| { readonly type: "opened"; readonly keep: boolean }
	/** A person has asked for the new version. */
	| { readonly type: "take over" };
