/** The worker: all of it is in serve.ts. */
import type { FromWorker, ToWorker } from "./messages";
import { serve } from "./serve";

/** What this file needs of a worker's global scope, which the page's types do not describe. */
interface Scope {
	postMessage(message: FromWorker, transfer: Transferable[]): void;
	onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
}

const scope = globalThis as unknown as Scope;
const answer = serve((message, transfer) => scope.postMessage(message, transfer));
scope.onmessage = ({ data }) => void answer(data);
