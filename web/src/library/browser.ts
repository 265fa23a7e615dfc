/**
 * The library's entry point in browsers: on a page plants grow in the page's workers, in a worker on its own thread.
 */
import { Core } from "../core/core";
import { compileCore } from "../core/loader";
import { PageRuntime } from "./page_runtime";
import { setRuntime } from "./runtime";
import { threadRuntime } from "./thread_runtime";

setRuntime(
	typeof document === "undefined"
		? threadRuntime(async (address) => Core.instantiate(await compileCore(address)))
		: new PageRuntime(),
);

export * from "./index";
