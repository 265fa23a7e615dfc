/**
 * Makes files off the page's thread, with one worker per file. A new worker remembers no failures, so that a script
 * that failed to load is fetched again with the next file.
 */
import { startWorker } from "../../core/spawn";
import { MessageError, translatedMessage } from "../../locale/message_error";
import type { Model } from "../../models/model";
import { text } from "../messages.generated";
import address from "./file_worker.ts?worker&url";
import type { FileRequest, FromExporter } from "./messages";

/** A script of the page could not be fetched; trying again may succeed. */
export class NotFetched extends MessageError {
	override name = "NotFetched";
	constructor() {
		super(text.message("not_loaded"));
	}
}

export interface ExportOptions {
	/** Cancels: the worker ends, and the promise rejects with the signal's reason. */
	signal?: AbortSignal;
	/** Starts a worker that runs generate/files/file_worker.ts. */
	spawn?: () => Worker;
}

/**
 * Makes a file in a worker. The worker does not know models that the page has added (`addModel`): their files are made
 * here.
 * @throws NotFetched, or a MessageError with the message of the failure
 */
export async function exportFile(model: Model, request: FileRequest, options: ExportOptions = {}): Promise<Blob> {
	const answer = await postRequest(request, options);
	if (answer.type === "made") return answer.file;
	if (answer.type === "failed") throw new MessageError(translatedMessage(answer.message));
	const { makeFile } = answer.type === "unknown" ? await import("./make").catch(notFetched) : notFetched();
	return makeFile(model, request);
}

/** Sends a request to a new worker and resolves with its answer; the worker ends in any case. */
function postRequest(request: FileRequest, { signal, spawn = spawnExporter }: ExportOptions): Promise<FromExporter> {
	return new Promise<FromExporter>((resolve, reject) => {
		signal?.throwIfAborted();
		const worker = spawn();
		const end = (settle: () => void) => {
			signal?.removeEventListener("abort", abort);
			worker.terminate();
			settle();
		};
		const abort = () => end(() => reject(signal?.reason));
		signal?.addEventListener("abort", abort);
		worker.onmessage = ({ data }: MessageEvent<FromExporter>) => end(() => resolve(data));
		worker.onmessageerror = () => end(() => reject(new MessageError(text.message("file_not_sent"))));
		worker.onerror = (event) => {
			event.preventDefault(); // Handled here; keep it out of the console.
			// A running script answers its failures: an error without a message means that it could not be fetched.
			end(() => reject(event.message ? new Error(event.message) : new NotFetched()));
		};
		try {
			worker.postMessage(request);
		} catch (error) {
			// A plant that the browser cannot copy (DataCloneError) never reaches the worker.
			end(() => reject(error));
		}
	});
}

/** Starts a worker that runs generate/files/file_worker.ts. */
function spawnExporter(): Worker {
	return startWorker(new URL(address, import.meta.url));
}

/** Throws the error of a script that could not be fetched. */
function notFetched(): never {
	throw new NotFetched();
}
