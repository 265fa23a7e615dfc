import { describe, expect, it, vi } from "vitest";
import type { SpecimenAnswer, SpecimenRequest } from "../../../web/src/offline/messages";
import { grownByPage, type PageClient } from "../../../web/src/offline/page_growth";
import { hostSpecimens } from "../../../web/src/offline/specimen_host";

const folder = "https://plants.example/app/";
const request: SpecimenRequest = {
	url: `${folder}specimens/duku.json`,
	method: "GET",
	headers: {},
	script: `${folder}assets/specimens-1.js`,
	cores: { "bunch.wasm": `${folder}assets/bunch-1.wasm` },
	release: "1",
};
const answer = (status: number, text: string): SpecimenAnswer => ({
	type: "answer",
	status,
	headers: { etag: text },
	body: new TextEncoder().encode(text),
});

/** A page that grows specimens, as the service worker sees it. */
function page(
	request: (request: SpecimenRequest, signal: AbortSignal) => Promise<SpecimenAnswer>,
	load = async () => request,
): PageClient {
	const workers = new EventTarget();
	hostSpecimens(workers, load);
	return {
		postMessage: (data, ports) => void workers.dispatchEvent(Object.assign(new Event("message"), { data, ports })),
	};
}
const deaf: PageClient = { postMessage: () => {} };

describe("a specimen that a page grows", () => {
	it("is grown by one page that says it can, as it was requested, however many pages are open", async () => {
		const requests = [1, 2, 3].map(() => vi.fn(async () => answer(200, "duku")));
		const response = await grownByPage([deaf, ...requests.map((request) => page(request))], request);
		expect([response?.status, response?.headers.get("etag"), await response?.text()]).toEqual([200, "duku", "duku"]);
		const requested = requests.filter((request) => request.mock.calls.length > 0);
		expect(requested).toHaveLength(1);
		expect(requested[0]).toHaveBeenCalledExactlyOnceWith(request, expect.any(AbortSignal));
	});

	it("has no body where HTTP has none", async () => {
		const response = await grownByPage([page(async () => answer(304, ""))], request);
		expect([response?.status, response?.body]).toEqual([304, null]);
	});

	it.each([
		["there is no page", []],
		["no page answers", [deaf, deaf]],
		["the page's worker cannot be started", [page(async () => ({ type: "unable" }))]],
		["the page's script does not come", [page(vi.fn(), () => Promise.reject(new TypeError("Failed to fetch")))]],
		["the page says nothing more", [page(() => new Promise(() => {}))]],
	])("is grown by none where %s", async (_, pages) => {
		expect(await grownByPage(pages, request, { patience: 50, longest: 50 })).toBeUndefined();
	});

	it("is cancelled in the page when its client aborts", async () => {
		const cancelled = vi.fn();
		const growing = page(
			(_, signal) =>
				new Promise((resolve) => {
					signal.addEventListener("abort", () => {
						cancelled();
						resolve({ type: "unable" });
					});
					setTimeout(() => client.abort(new Error("closed")), 1);
				}),
		);
		const client = new AbortController();
		await expect(grownByPage([growing], request, { signal: client.signal })).rejects.toThrow("closed");
		expect(cancelled).toHaveBeenCalledOnce();
	});

	it("passes over what the service worker says of something else", () => {
		const load = vi.fn();
		const workers = new EventTarget();
		hostSpecimens(workers, load);
		const port = { postMessage: vi.fn() };
		for (const data of ["other", { type: "take over" }, undefined])
			workers.dispatchEvent(Object.assign(new Event("message"), { data, ports: [port] }));
		expect(port.postMessage).not.toHaveBeenCalled();
	});
});
