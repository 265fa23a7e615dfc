/** Messages between the server's thread and the threads that grow plants. */

export interface ThreadRequest {
	readonly id: number;
	readonly url: string;
	readonly method: string;
	readonly headers: Readonly<Record<string, string>>;
}

export interface ThreadResponse {
	readonly id: number;
	readonly status: number;
	readonly headers: Readonly<Record<string, string>>;
	/** Transferred, not copied. */
	readonly body: Uint8Array<ArrayBuffer>;
	/** Memory that the thread holds after the request: its objects, buffers and cores, bytes. */
	readonly heapBytes: number;
}
