/** The worker that makes files: all of it is in serve.ts. */
import type { FileRequest, FromExporter } from "./messages";
import { answerTo } from "./serve";

/** What this file needs of a worker's global scope, which the page's types do not describe. */
interface Scope {
	postMessage(message: FromExporter): void;
	onmessage: ((event: MessageEvent<FileRequest>) => void) | null;
}

const scope = globalThis as unknown as Scope;
scope.onmessage = async ({ data }) => {
	scope.postMessage(await answerTo(data));
};
