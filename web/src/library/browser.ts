/**
 * The library's entry point in browsers: on a page plants grow in workers, two at the most, in a worker on its own
 * thread.
 */
import { Core } from "../core/core";
import { compileCore } from "../core/loader";
import { Pool } from "../core/pool";
import { spawnWorker } from "../core/spawn";
import { PageRuntime } from "./page_runtime";
import { setRuntime } from "./runtime";
import { threadRuntime } from "./thread_runtime";

const workers = () =>
	new Pool({ spawn: spawnWorker, compile: compileCore, workers: Math.min(navigator.hardwareConcurrency, 2) });

setRuntime(
	typeof document === "undefined"
		? threadRuntime(async (address) => Core.instantiate(await compileCore(address)))
		: new PageRuntime(workers),
);

export * from "./index";
