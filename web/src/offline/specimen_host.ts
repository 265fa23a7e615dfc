/** Grows specimens for the service worker in a page, with a worker of its own. */
import { CANCEL, FREE, GROWTH_NEEDED, type SpecimenAnswer, type SpecimenRequest } from "./messages";

type GrowRequest = (request: SpecimenRequest, signal: AbortSignal) => Promise<SpecimenAnswer>;

/** Starts to grow specimens for the service worker. The script is fetched with the first request. */
export function hostSpecimens(
	workers: EventTarget = navigator.serviceWorker,
	load: () => Promise<GrowRequest> = loadQueue,
): void {
	workers.addEventListener("message", (event) => {
		const { data, ports } = event as MessageEvent<unknown>;
		const [port] = ports;
		if (data !== GROWTH_NEEDED || !port) return;
		const cancelling = new AbortController();
		port.onmessage = async ({ data: request }: MessageEvent<SpecimenRequest | typeof CANCEL>) => {
			if (request === CANCEL) {
				cancelling.abort();
				return;
			}
			const answer = await load().then(
				(grow) => grow(request, cancelling.signal),
				(): SpecimenAnswer => ({ type: "unable" }),
			);
			port.postMessage(answer, answer.type === "answer" ? [answer.body.buffer] : []);
			port.close();
		};
		port.postMessage(FREE);
	});
}

let queue: { request: GrowRequest } | undefined;

/** Loads the queue's script and returns the function that adds a request to the queue. */
async function loadQueue(): Promise<GrowRequest> {
	const { SpecimenQueue } = await import("./specimen_queue");
	queue ??= new SpecimenQueue();
	return queue.request.bind(queue);
}
