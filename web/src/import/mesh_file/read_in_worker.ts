/** Reads mesh files off the main thread, with one worker per file. */
import { startWorker } from "../../core/spawn";
import { translatedMessage } from "../../locale/message_error";
import type { Message } from "../../locale/texts";
import type { ClosedMesh } from "../../specimen/closed_mesh";
import { text } from "../messages.generated";
import address from "./mesh_worker.ts?worker&url";
import type { FromMeshReader } from "./messages";
import { MeshFileError } from "./soup";

/**
 * Reads a file in a new worker, which ends in any case.
 * @param spawn starts a worker that runs mesh_worker.ts
 * @throws MeshFileError with the reason in plain words
 */
export function readMeshInWorker(file: File, spawn: () => Worker = spawnReader): Promise<ClosedMesh> {
	return new Promise((resolve, reject) => {
		const worker = spawn();
		const end = (settle: () => void) => {
			worker.terminate();
			settle();
		};
		const fail = (message: Message | string) => end(() => reject(new MeshFileError(message)));
		worker.onmessage = ({ data }: MessageEvent<FromMeshReader>) =>
			data.type === "read" ? end(() => resolve(data.mesh)) : fail(translatedMessage(data.message));
		worker.onmessageerror = () => fail(text.message("mesh_file_not_sent"));
		worker.onerror = (event) => {
			event.preventDefault(); // Reported here; the console shows no second error.
			// Errors of a running script are sent as messages; an error event without a message means that the script
			// did not load.
			fail(event.message || text.message("reader_not_loaded"));
		};
		worker.postMessage(file);
	});
}

/** Starts a worker that runs mesh_worker.ts. */
function spawnReader(): Worker {
	return startWorker(new URL(address, import.meta.url));
}
