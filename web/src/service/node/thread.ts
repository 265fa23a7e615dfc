/** A thread that grows plants for the server, with its own cores. */
import { getHeapStatistics } from "node:v8";
import { parentPort } from "node:worker_threads";
import { loadCoreFromBytes } from "../../core/loader";
import { text } from "../messages.generated";
import { ERROR_HEADERS, errorBody } from "../refused";
import { makeService } from "../service";
import { coreBytes } from "./cores";
import type { ThreadRequest, ThreadResponse } from "./messages";

type Answer = Omit<ThreadResponse, "id" | "heapBytes">;

/**
 * Answers the requests that the server's main thread posts to this thread.
 * @param release version of the program
 */
export function answerRequests(release: string): void {
	const service = makeService({ release, loadCore: async (wasm) => loadCoreFromBytes(await coreBytes(wasm)) });
	parentPort?.on("message", async (request: ThreadRequest) => {
		const response = await respond(service, request).catch(internalError);
		const message: ThreadResponse = { id: request.id, ...response, heapBytes: heapBytes() };
		parentPort?.postMessage(message, [message.body.buffer]);
	});
}

/** Returns the bytes of this thread's objects, and of their buffers and memories of WebAssembly. */
function heapBytes(): number {
	const { total_heap_size, external_memory } = getHeapStatistics();
	return total_heap_size + external_memory;
}

/** Answers a request by the service, with the whole body as bytes. */
async function respond(
	service: ReturnType<typeof makeService>,
	{ url, method, headers }: ThreadRequest,
): Promise<Answer> {
	const response = await service(new Request(url, { method, headers }));
	const body = new Uint8Array(await response.arrayBuffer());
	return { status: response.status, headers: Object.fromEntries(response.headers), body };
}

/** Returns the answer where a request is malformed or an answer cannot be read: the thread itself stays valid. */
function internalError(): Answer {
	const body = new TextEncoder().encode(errorBody(text.message("internal_error")));
	return { status: 500, headers: ERROR_HEADERS, body };
}
