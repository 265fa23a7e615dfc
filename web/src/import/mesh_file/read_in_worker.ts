/** Reads mesh files off the main thread, with one worker per file. */
import { startWorker } from "../../core/spawn";
import type { ClosedMesh } from "../../specimen/closed_mesh";
import address from "./mesh_worker.ts?worker&url";
import type { FromMeshReader } from "./messages";
import { MeshFileError } from "./soup";

/**
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
		const fail = (message: string) => end(() => reject(new MeshFileError(message)));
		worker.onmessage = ({ data }: MessageEvent<FromMeshReader>) =>
			data.type === "read" ? end(() => resolve(data.mesh)) : fail(data.message);
		worker.onmessageerror = () => fail("The file could not be handed over.");
		worker.onerror = (event) => {
			event.preventDefault(); // Reported here; the console shows no second error.
			// Errors of a running script are sent as messages; an error event without a message means that the script
			// did not load.
			fail(event.message || "Part of the page could not be fetched; check the connection and try again.");
		};
		worker.postMessage(file);
	});
}

function spawnReader(): Worker {
	return startWorker(new URL(address, import.meta.url));
}
