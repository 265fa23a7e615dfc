/** A thread that grows plants for the server, with its own cores. */
import { parentPort } from "node:worker_threads";
import { loadCoreFromBytes } from "../../core/loader";
import { makeService } from "../service";
import { coreBytes } from "./cores";
import type { ThreadRequest, ThreadResponse } from "./messages";

export function answerRequests(release: string): void {
	const service = makeService({ release, loadCore: async (wasm) => loadCoreFromBytes(await coreBytes(wasm)) });
	parentPort?.on("message", async (request: ThreadRequest) => {
		const response = await respond(service, request).catch(internalError);
		const message: ThreadResponse = { id: request.id, ...response };
		parentPort?.postMessage(message, [message.body.buffer]);
	});
}

async function respond(
	service: ReturnType<typeof makeService>,
	{ url, method, headers }: ThreadRequest,
): Promise<Omit<ThreadResponse, "id">> {
	const response = await service(new Request(url, { method, headers }));
	const body = new Uint8Array(await response.arrayBuffer());
	return { status: response.status, headers: Object.fromEntries(response.headers), body };
}

/** What is answered where even the request cannot be built or the answer cannot be read: the thread itself goes on. */
function internalError(): Omit<ThreadResponse, "id"> {
	const body = new TextEncoder().encode("Internal error\n");
	return { status: 500, headers: { "content-type": "text/plain; charset=utf-8", "cache-control": "no-store" }, body };
}
