/** The worker's side: brings the core to life and answers requests one after the other. */
import { Core } from "./core";
import { CoreError } from "./errors";
import type { FromWorker, ToWorker } from "./messages";
import { buffersOf } from "../models/bunch/read_grown";

/** @returns what to call with every message; `post` sends an answer, moving the buffers instead of copying them */
export function serve(
	post: (message: FromWorker, transfer: Transferable[]) => void,
): (message: ToWorker) => Promise<void> {
	let core: Promise<Core> | undefined;

	async function start(module: WebAssembly.Module): Promise<void> {
		core = Core.instantiate(module);
		try {
			await core;
			post({ type: "ready" }, []);
		} catch (error) {
			post({ type: "broken", message: textOf(error) }, []);
		}
	}

	async function grow(id: number, request: Uint8Array): Promise<void> {
		try {
			if (!core) throw new Error("The core has not been started.");
			const grown = (await core).grow(request);
			post({ type: "grown", id, grown }, buffersOf(grown));
		} catch (error) {
			const { message } = error as Error;
			if (error instanceof CoreError) {
				const { reason, line, column } = error;
				post({ type: "failed", id, reason, message, line, column }, []);
			} else {
				post({ type: "trapped", id, message: textOf(error) }, []);
			}
		}
	}

	return (message) => (message.type === "start" ? start(message.module) : grow(message.id, message.request));
}

function textOf(error: unknown): string {
	return error instanceof Error ? error.message : String(error);
}
