import { describe, expect, it, vi } from "vitest";
import { exportFile, NotFetched } from "../../../../web/src/generate/files/exporter";
import type { FileRequest, FromExporter } from "../../../../web/src/generate/files/messages";
import { messageOf } from "../../../../web/src/locale/message_error";
import type { Model } from "../../../../web/src/models/model";
import { EMPTY_PLANT } from "../../../../web/src/plant/plant";
import { fromPreset } from "../../../../web/src/specimen/from_preset";
import { toy } from "../../toy";

const format = { key: "txt", title: "", about: "", suffix: ".txt", type: "text/plain", make: async () => "here" };
const model = { ...toy, formats: [format] } as unknown as Model;
const specimen = fromPreset(model);
const request: FileRequest = {
	model: "toy",
	format: "txt",
	grown: EMPTY_PLANT,
	specimen,
	link: "?v=2",
	name: "plain-1",
};

/** A worker that a test answers for. */
class Standin {
	onmessage?: (event: { data: FromExporter }) => void;
	onerror?: (event: { message?: string; preventDefault(): void }) => void;
	postMessage = vi.fn();
	terminate = vi.fn();
}

function requesting(options: { signal?: AbortSignal } = {}) {
	const worker = new Standin();
	const file = exportFile(model, request, { ...options, spawn: () => worker as unknown as Worker });
	return { worker, file };
}

describe("making a file", () => {
	it("asks a worker, hands over what it made and ends it", async () => {
		const { worker, file } = requesting();
		expect(worker.postMessage).toHaveBeenCalledExactlyOnceWith(request);
		const made = new Blob(["made"]);
		worker.onmessage?.({ data: { type: "made", file: made } });
		expect(await file).toBe(made);
		expect(worker.terminate).toHaveBeenCalledOnce();
	});

	it("makes here what is of a model that the worker does not know", async () => {
		const { worker, file } = requesting();
		worker.onmessage?.({ data: { type: "unknown" } });
		expect(await (await file).text()).toBe("here");
	});

	it("ends with the worker when it is cancelled", async () => {
		const cancel = new AbortController();
		const { worker, file } = requesting({ signal: cancel.signal });
		cancel.abort(new Error("enough"));
		await expect(file).rejects.toThrow("enough");
		expect(worker.terminate).toHaveBeenCalledOnce();
	});

	it("ends the worker and stops listening for cancelling when the request cannot be sent to it", async () => {
		const cancel = new AbortController();
		const heard = vi.spyOn(cancel.signal, "removeEventListener");
		const worker = new Standin();
		worker.postMessage.mockImplementation((message) => void structuredClone({ message, uncloneable: () => {} }));
		const spawn = () => worker as unknown as Worker;
		const file = exportFile(model, request, { spawn, signal: cancel.signal });
		await expect(file).rejects.toMatchObject({ name: "DataCloneError" });
		expect(worker.terminate).toHaveBeenCalledOnce();
		expect(heard).toHaveBeenCalledOnce();
	});

	it("tells what cannot be made from what did not come", async () => {
		const failing = requesting();
		failing.worker.onmessage?.({ data: { type: "failed", message: messageOf("too large") } });
		await expect(failing.file).rejects.toThrow("too large");
		const unfetched = requesting();
		unfetched.worker.onmessage?.({ data: { type: "unfetched" } });
		await expect(unfetched.file).rejects.toBeInstanceOf(NotFetched);
		const missing = requesting();
		const preventDefault = vi.fn();
		missing.worker.onerror?.({ preventDefault });
		await expect(missing.file).rejects.toBeInstanceOf(NotFetched);
		expect(preventDefault).toHaveBeenCalledOnce();
		const broken = requesting();
		broken.worker.onerror?.({ message: "out of memory", preventDefault });
		await expect(broken.file).rejects.toThrow("out of memory");
	});
});
