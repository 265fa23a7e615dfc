/** The library's front door under Node: plants grow on the thread that asks. */
import { readFile } from "node:fs/promises";
import { loadCoreFromBytes } from "../core/loader";
import { layGround } from "./ground";
import { threadGround } from "./thread_ground";

layGround(threadGround(async (address) => loadCoreFromBytes(await readFile(new URL(address)))));

export * from "./index";
