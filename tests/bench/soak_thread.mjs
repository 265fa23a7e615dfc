/** A thread of the model service that reports to `npm run bench -- soak` the memory of its live cores and its heap. */
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";
import { workerData } from "node:worker_threads";

setFlagsFromString("--expose-gc");
const collect = runInNewContext("gc");

/**
 * Memories of all cores ever created, and of other WebAssembly instances; unreferenced ones disappear after garbage
 * collection.
 */
let memories = [];
const { instantiate } = WebAssembly;
WebAssembly.instantiate = async (...given) => {
	const made = await instantiate.apply(WebAssembly, given);
	memories.push(new WeakRef((made.instance ?? made).exports.memory));
	return made;
};

const { answerRequests } = await import(workerData.program);
workerData.port.on("message", () => {
	collect();
	memories = memories.filter((memory) => memory.deref());
	const cores = memories.reduce((bytes, memory) => bytes + (memory.deref()?.buffer.byteLength ?? 0), 0);
	workerData.port.postMessage({ cores, heap: process.memoryUsage().heapUsed });
});
answerRequests("soak");
