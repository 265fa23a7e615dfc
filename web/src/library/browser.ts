/** The library's front door in browsers: on a page plants grow in workers, two at the most, in a worker on its own thread. */
import { Core } from "../core/core";
import { compileCore } from "../core/loader";
import { Pool } from "../core/pool";
import { spawnWorker } from "../core/spawn";
import { layGround } from "./ground";
import { PageGround } from "./page_ground";
import { threadGround } from "./thread_ground";

const workers = () =>
	new Pool({ spawn: spawnWorker, compile: compileCore, seats: Math.min(navigator.hardwareConcurrency, 2) });

layGround(
	typeof document === "undefined"
		? threadGround(async (address) => Core.instantiate(await compileCore(address)))
		: new PageGround(workers),
);

export * from "./index";
