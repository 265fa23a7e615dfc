/** The script of the worker that makes files; serve.ts has the logic. */
import type { FileRequest, FromExporter } from "./messages";
import { answerTo } from "./serve";

/** The part of a worker's global scope that this file needs; the page's types do not describe it. */
interface Scope {
	postMessage(message: FromExporter): void;
	onmessage: ((event: MessageEvent<FileRequest>) => void) | null;
}

const scope = globalThis as unknown as Scope;
scope.onmessage = async ({ data }) => {
	scope.postMessage(await answerTo(data));
};
