/** A thread that answers, with cores of its own. */
import { parentPort } from "node:worker_threads";
import { loadCoreFromBytes } from "../../core/loader";
import { makeService } from "../service";
import { coreBytes } from "./cores";
import type { Question, Reply } from "./messages";

export function answerQuestions(release: string): void {
	const service = makeService({ release, loadCore: async (wasm) => loadCoreFromBytes(await coreBytes(wasm)) });
	parentPort?.on("message", async ({ id, url, method, headers }: Question) => {
		const answer = await service(new Request(url, { method, headers }));
		const body = new Uint8Array(await answer.arrayBuffer());
		const reply: Reply = { id, status: answer.status, headers: Object.fromEntries(answer.headers), body };
		parentPort?.postMessage(reply, [body.buffer]);
	});
}
