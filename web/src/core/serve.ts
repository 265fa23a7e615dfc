/** The worker's side: instantiates cores and answers requests one after the other. */
import { messageOf } from "../locale/message_error";
import { Core } from "./core";
import { CoreError, CoreTrap } from "./errors";
import type { FromWorker, ToWorker } from "./messages";
import { text } from "./messages.generated";

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

	/**
	 * Instantiates a core of the module and posts `ready` or `broken`. The promise is stored at once under the name of
	 * the WebAssembly file, so that a growth that arrives meanwhile waits for it.
	 */
	async function start({ wasm, module }: Extract<ToWorker, { type: "start" }>): Promise<void> {
		const core = Core.instantiate(module);
		cores.set(wasm, core);
		try {
			started.push(await core);
			post({ type: "ready" }, []);
		} catch (error) {
			post({ type: "broken", message: messageOf(error) }, []);
		}
	}

	/**
	 * Grows a plant and posts the result, whose buffer is transferred. Errors that the core reports are posted as
	 * `failed`, all others as `trapped`: then the page replaces this worker.
	 */
	async function grow({ id, wasm, blocks }: Extract<ToWorker, { type: "grow" }>): Promise<void> {
		try {
			const core = await cores.get(wasm);
			if (!core) throw new CoreTrap(text.message("not_started"));
			const { columns, milliseconds } = core.grow(blocks);
			const container = columns.bytes;
			post({ type: "grown", id, container, milliseconds, memoryBytes: memoryBytes() }, [container.buffer]);
		} catch (error) {
			if (error instanceof CoreError) {
				const { reason, line, column } = error;
				post({ type: "failed", id, reason, message: messageOf(error), line, column, memoryBytes: memoryBytes() }, []);
			} else {
				post({ type: "trapped", id, message: messageOf(error) }, []);
			}
		}
	}

	return (message) => (message.type === "start" ? start(message) : grow(message));
}
