/** The library's entry point under Node: plants grow on the calling thread. */
import { readFile } from "node:fs/promises";
import { loadCoreFromBytes } from "../core/loader";
import { setRuntime } from "./runtime";
import { threadRuntime } from "./thread_runtime";

setRuntime(threadRuntime(async (address) => loadCoreFromBytes(await readFile(new URL(address)))));

export * from "./index";
