/** A thread of the model service that tells `npm run bench -- soak` what it holds: the memory of its cores that are alive, and its heap. */
import { setFlagsFromString } from "node:v8";
import { runInNewContext } from "node:vm";
import { workerData } from "node:worker_threads";

setFlagsFromString("--expose-gc");
const collect = runInNewContext("gc");

/** Of every core that was ever brought to life, and what else is WebAssembly; one that nobody holds any more is gone after collecting. */
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
