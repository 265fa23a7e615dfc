/** Starts workers. */
import address from "./worker.ts?worker&url";

/** Starts a worker for the core. */
export function spawnWorker(): Worker {
	return startWorker(new URL(address, import.meta.url));
}

/**
 * Starts a worker of a script, a module. A page may only start workers of its own origin: a script from another host is
 * imported by a small script of this origin.
 */
export function startWorker(script: URL): Worker {
	if (script.origin === location.origin) return new Worker(script, { type: "module" });
	const source = new Blob([`import ${JSON.stringify(script.href)};`], { type: "text/javascript" });
	const url = URL.createObjectURL(source);
	const worker = new Worker(url, { type: "module" });
	worker.addEventListener("message", () => URL.revokeObjectURL(url), { once: true });
	return worker;
}
