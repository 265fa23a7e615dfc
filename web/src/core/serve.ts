/** The worker's side: instantiates cores and answers requests one after the other. */
import { Core } from "./core";
import { CoreError } from "./errors";
import type { FromWorker, ToWorker } from "./messages";

/**
 * Serves requests in a worker.
 * @param post sends an answer, moving the buffers instead of copying them
 * @returns the handler of messages
 */
export function serve(
	post: (message: FromWorker, transfer: Transferable[]) => void,
): (message: ToWorker) => Promise<void> {
	/** Cores by the names of their modules. */
	const cores = new Map<string, Promise<Core>>();
	const started: Core[] = [];
	const memoryBytes = () => started.reduce((sum, core) => sum + core.memoryBytes, 0);

	async function start({ wasm, module }: Extract<ToWorker, { type: "start" }>): Promise<void> {
		const core = Core.instantiate(module);
		cores.set(wasm, core);
		try {
			started.push(await core);
			post({ type: "ready" }, []);
		} catch (error) {
			post({ type: "broken", message: textOf(error) }, []);
		}
	}

	async function grow({ id, wasm, blocks }: Extract<ToWorker, { type: "grow" }>): Promise<void> {
		try {
			const core = await cores.get(wasm);
			if (!core) throw new Error("The core has not been started.");
			const { columns, milliseconds } = core.grow(blocks);
			const container = columns.bytes;
			post({ type: "grown", id, container, milliseconds, memoryBytes: memoryBytes() }, [container.buffer]);
		} catch (error) {
			if (error instanceof CoreError) {
				const { reason, message, line, column } = error;
				post({ type: "failed", id, reason, message, line, column, memoryBytes: memoryBytes() }, []);
			} else {
				post({ type: "trapped", id, message: textOf(error) }, []);
			}
		}
	}

	return (message) => (message.type === "start" ? start(message) : grow(message));
}

function textOf(error: unknown): string {
	return error instanceof Error ? error.message : String(error);
}
