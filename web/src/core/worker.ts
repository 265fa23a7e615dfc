/** The script of the worker; serve.ts has the logic. */
import type { FromWorker, ToWorker } from "./messages";
import { serve } from "./serve";

/** The part of a worker's global scope that this file needs; the page's types do not describe it. */
interface Scope {
	postMessage(message: FromWorker, transfer: Transferable[]): void;
	onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
}

const scope = globalThis as unknown as Scope;
const answer = serve((message, transfer) => scope.postMessage(message, transfer));
scope.onmessage = ({ data }) => void answer(data);
