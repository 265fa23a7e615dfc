import { describe, expect, it, vi } from "vitest";
import type { FromMeshReader } from "../../../../web/src/import/mesh_file/messages";
import { readMeshInWorker } from "../../../../web/src/import/mesh_file/read_in_worker";
import { messageOf } from "../../../../web/src/locale/message_error";

/** A worker whose messages the test sends. */
class WorkerDouble {
	onmessage?: (event: { data: FromMeshReader }) => void;
	onerror?: (event: { message?: string; preventDefault(): void }) => void;
	postMessage = vi.fn();
	terminate = vi.fn();
}

const file = new File(["v 0 0 0"], "point.obj");

function reading() {
	const worker = new WorkerDouble();
	return { worker, mesh: readMeshInWorker(file, () => worker as unknown as Worker) };
}

describe("reading a mesh file in a worker", () => {
	it("sends the file, resolves with the mesh and ends the worker", async () => {
		const { worker, mesh } = reading();
		expect(worker.postMessage).toHaveBeenCalledExactlyOnceWith(file);
		worker.onmessage?.({ data: { type: "read", mesh: { points: [0, 0, 0], triangles: [] } } });
		expect(await mesh).toEqual({ points: [0, 0, 0], triangles: [] });
		expect(worker.terminate).toHaveBeenCalledOnce();
	});

	it("rejects with the reason, and ends the worker", async () => {
		const { worker, mesh } = reading();
		worker.onmessage?.({ data: { type: "failed", message: messageOf("The mesh is flat.") } });
		await expect(mesh).rejects.toThrow("The mesh is flat.");
		expect(worker.terminate).toHaveBeenCalledOnce();
	});

	it("rejects if the worker's script does not load, or runs out of memory", async () => {
		const lost = reading();
		lost.worker.onerror?.({ preventDefault: () => {} });
		await expect(lost.mesh).rejects.toThrow("Part of the app failed to load.");
		const full = reading();
		full.worker.onerror?.({ message: "out of memory", preventDefault: () => {} });
		await expect(full.mesh).rejects.toThrow("out of memory");
	});

	it("answers from the worker's script with the mesh or the reason", async () => {
		const answers: FromMeshReader[] = [];
		const scope = globalThis as unknown as { postMessage?: unknown; onmessage?: (event: unknown) => Promise<void> };
		scope.postMessage = (message: FromMeshReader) => answers.push(message);
		try {
			await import("../../../../web/src/import/mesh_file/mesh_worker");
			await scope.onmessage?.({ data: file });
			const tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
			await scope.onmessage?.({ data: new File([tetrahedron], "tetrahedron.obj") });
		} finally {
			scope.postMessage = undefined;
			scope.onmessage = undefined;
		}
		expect(answers[0]).toEqual({
			type: "failed",
			message: {
				code: "import.mesh_without_triangles",
				args: {},
				text: "The file contains no triangles. Export the mesh again.",
			},
		});
		expect(answers[1].type === "read" && answers[1].mesh.triangles).toHaveLength(12);
	});
});
