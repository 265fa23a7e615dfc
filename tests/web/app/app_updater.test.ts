import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { AppUpdater } from "../../../web/src/app/app_updater";
import { FakeCaches } from "../offline/fake_caches";

const folder = "https://plants.example/app/";

class Worker extends EventTarget {
	postMessage = vi.fn();
	constructor(public state: string) {
		super();
	}
	become(state: string): void {
		this.state = state;
		this.dispatchEvent(new Event("statechange"));
	}
}

/** A registration whose worker controls the page already. */
class Registration extends EventTarget {
	scope = folder;
	active: Worker | null = new Worker("activated");
	installing: Worker | null = null;
	waiting: Worker | null = null;
	update = vi.fn(async () => {});
	unregister = vi.fn(async () => true);
}

let registration: Registration;
let workers: EventTarget;
let caches: FakeCaches;
let page: () => Promise<Response>;
const reload = vi.fn();
const offer = vi.fn<(reload: () => void) => void>();

beforeEach(() => {
	vi.useFakeTimers();
	registration = new Registration();
	workers = Object.assign(new EventTarget(), {
		controller: registration.active,
		getRegistration: async () => undefined,
		register: async () => registration,
		ready: Promise.resolve(registration),
	});
	page = async () => new Response('<script src="./assets/index-1.js">');
	vi.stubGlobal("window", {});
	vi.stubGlobal("location", { reload });
	caches = new FakeCaches();
	vi.stubGlobal("caches", caches);
	vi.stubGlobal("navigator", { onLine: true, serviceWorker: workers });
	vi.stubGlobal("fetch", () => page());
	const document = { baseURI: folder, querySelector: () => ({ src: `${folder}assets/index-1.js` }) };
	vi.stubGlobal("document", Object.assign(new EventTarget(), document));
});
afterEach(() => {
	vi.unstubAllGlobals();
	vi.useRealTimers();
	vi.clearAllMocks();
});

async function started(): Promise<AppUpdater> {
	const updater = new AppUpdater(offer);
	const starting = updater.start();
	await vi.runAllTimersAsync();
	await starting;
	return updater;
}

/** Installs the next version. @param become its state afterwards */
async function arrives(become: (worker: Worker) => void): Promise<Worker> {
	const worker = new Worker("installing");
	registration.installing = worker;
	registration.dispatchEvent(new Event("updatefound"));
	await vi.runAllTimersAsync();
	expect(offer).not.toHaveBeenCalled();
	registration.installing = null;
	become(worker);
	await vi.runAllTimersAsync();
	return worker;
}

it("stores the app, unless the browser saves data", async () => {
	await started();
	expect(registration.active?.postMessage).toHaveBeenLastCalledWith({ type: "opened", keep: true });
	vi.stubGlobal("navigator", { onLine: true, serviceWorker: workers, connection: { saveData: true } });
	await started();
	expect(registration.active?.postMessage).toHaveBeenLastCalledWith({ type: "opened", keep: false });
});

it("offers a waiting version, and switches to it on request", async () => {
	await started();
	const next = await arrives((worker) => {
		registration.waiting = worker;
		worker.become("installed");
	});
	expect(offer).toHaveBeenCalledOnce();
	expect(next.postMessage).not.toHaveBeenCalled();
	offer.mock.lastCall?.[0]();
	expect(next.postMessage).toHaveBeenCalledExactlyOnceWith({ type: "take over" });
	expect(reload).not.toHaveBeenCalled();
	workers.dispatchEvent(new Event("controllerchange"));
	expect(reload).toHaveBeenCalledOnce();
});

it("does not reload a page when another tab switches to the new version", async () => {
	await started();
	await arrives((worker) => {
		registration.waiting = worker;
		worker.become("installed");
	});
	workers.dispatchEvent(new Event("controllerchange"));
	expect(reload).not.toHaveBeenCalled();
	registration.waiting = null;
	offer.mock.lastCall?.[0]();
	expect(reload).toHaveBeenCalledOnce();
});

it("offers nothing if the next version failed or became active at once", async () => {
	await started();
	await arrives((worker) => worker.become("redundant"));
	await arrives((worker) => {
		registration.active = worker;
		worker.become("activated");
	});
	expect(offer).not.toHaveBeenCalled();
});

const newer = async () => new Response('<script src="./assets/index-2.js">');

it("checks for a newer page when a script could not be fetched", async () => {
	const updater = await started();
	const look = () => Promise.all([updater.look(), vi.runAllTimersAsync()]);
	await look();
	page = async () => new Response("", { status: 503 });
	await look();
	page = () => Promise.reject(new TypeError("no network"));
	await look();
	expect(offer).not.toHaveBeenCalled();
	page = newer;
	await look();
	expect(offer).toHaveBeenCalledOnce();
});

it("unregisters the worker for a newer page that it cannot store", async () => {
	page = newer;
	await caches.open(`panicle ${folder} 1`);
	await started();
	expect(registration.update).toHaveBeenCalledOnce();
	expect(offer).toHaveBeenCalledOnce();
	expect(registration.unregister).not.toHaveBeenCalled();
	offer.mock.lastCall?.[0]();
	await vi.runAllTimersAsync();
	expect(registration.unregister).toHaveBeenCalledOnce();
	expect(await caches.keys()).toEqual([]);
	expect(reload).toHaveBeenCalledOnce();
});

it("retains the worker if a newer version waits", async () => {
	page = newer;
	registration.waiting = new Worker("installed");
	await started();
	offer.mock.lastCall?.[0]();
	await vi.runAllTimersAsync();
	expect(registration.waiting?.postMessage).toHaveBeenCalledExactlyOnceWith({ type: "take over" });
	expect(registration.unregister).not.toHaveBeenCalled();
});

it("checks for a new version when it becomes visible, at most once an hour", async () => {
	await started();
	const turnTo = () => document.dispatchEvent(new Event("visibilitychange"));
	turnTo();
	expect(registration.update).not.toHaveBeenCalled();
	vi.setSystemTime(Date.now() + 3_600_001);
	turnTo();
	turnTo();
	expect(registration.update).toHaveBeenCalledOnce();
});
