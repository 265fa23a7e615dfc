/** What the server's thread and those that answer say to each other. */

export interface Question {
	readonly id: number;
	readonly url: string;
	readonly method: string;
	readonly headers: Readonly<Record<string, string>>;
}

export interface Reply {
	readonly id: number;
	readonly status: number;
	readonly headers: Readonly<Record<string, string>>;
	/** Moved, not copied. */
	readonly body: Uint8Array<ArrayBuffer>;
}
