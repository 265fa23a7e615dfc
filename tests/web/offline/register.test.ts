import { afterEach, expect, it, vi } from "vitest";
import { registerWorker } from "../../../web/src/offline/register";
import { FakeCaches } from "./fake_caches";

const folder = new URL("https://plants.example/app/");
const script = `${folder}service-worker.js`;

afterEach(() => vi.unstubAllGlobals());

/** A browser that has a worker for a scope already, perhaps, and a host that answers with a status for the app's. */
function browser({ scope = folder.href, scriptURL = "", status = 200, onLine = true } = {}) {
	const unregister = vi.fn();
	const before = scriptURL ? { scope, active: { scriptURL }, unregister } : undefined;
	const register = vi.fn(async () => "registered");
	vi.stubGlobal("navigator", { onLine, serviceWorker: { getRegistration: async () => before, register } });
	const caches = new FakeCaches();
	vi.stubGlobal("caches", caches);
	vi.stubGlobal("fetch", async () => {
		if (status === 0) throw new TypeError("no network");
		return new Response(null, { status });
	});
	return { register, unregister, caches };
}

it("registers past what the browser keeps of the script", async () => {
	const { register } = browser();
	expect(await registerWorker(folder)).toBe("registered");
	expect(register).toHaveBeenCalledExactlyOnceWith(script, { updateViaCache: "none" });
});

it.each([0, 200, 503])("goes on with its worker where the host answers %i", async (status) => {
	const { register, unregister } = browser({ scriptURL: script, status });
	expect(await registerWorker(folder)).toBe("registered");
	expect(register).toHaveBeenCalledOnce();
	expect(unregister).not.toHaveBeenCalled();
});

it.each([404, 410])("clears away what it kept where the script is gone (%i), and nothing else", async (status) => {
	const { register, unregister, caches } = browser({ scriptURL: script, status });
	for (const name of [`panicle ${folder} 1`, `panicle ${folder}inner/ 1`, "another"]) await caches.open(name);
	expect(await registerWorker(folder)).toBeUndefined();
	expect(await caches.keys()).toEqual([`panicle ${folder}inner/ 1`, "another"]);
	expect(unregister).toHaveBeenCalledOnce();
	expect(register).not.toHaveBeenCalled();
});

it("leaves a host’s own worker in its place", async () => {
	const { register, unregister } = browser({ scriptURL: `${folder}own.js`, status: 404 });
	expect(await registerWorker(folder)).toBeUndefined();
	expect(register).not.toHaveBeenCalled();
	expect(unregister).not.toHaveBeenCalled();
});

it("stands beside one of a folder above", async () => {
	const { register } = browser({ scope: "https://plants.example/", scriptURL: "https://plants.example/own.js" });
	await registerWorker(folder);
	expect(register).toHaveBeenCalledOnce();
});

it("does nothing where there are no workers, and none for a file of one’s own", async () => {
	const { register } = browser();
	expect(await registerWorker(new URL("file:///plants/"))).toBeUndefined();
	vi.stubGlobal("navigator", {});
	expect(await registerWorker(folder)).toBeUndefined();
	expect(register).not.toHaveBeenCalled();
});
