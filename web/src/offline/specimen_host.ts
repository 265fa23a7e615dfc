/** Grows specimens for the service worker in a page, with a worker of its own. */
import { FREE, GROWTH_NEEDED, type SpecimenAnswer, type SpecimenRequest } from "./messages";

type GrowRequest = (request: SpecimenRequest) => Promise<SpecimenAnswer>;

/** Starts to grow specimens for the service worker. The script is fetched with the first request. */
export function hostSpecimens(
	workers: EventTarget = navigator.serviceWorker,
	load: () => Promise<GrowRequest> = loadQueue,
): void {
	workers.addEventListener("message", (event) => {
		const { data, ports } = event as MessageEvent<unknown>;
		const [port] = ports;
		if (data !== GROWTH_NEEDED || !port) return;
		port.onmessage = async ({ data: request }: MessageEvent<SpecimenRequest>) => {
			const answer = await load().then(
				(grow) => grow(request),
				(): SpecimenAnswer => ({ type: "unable" }),
			);
			port.postMessage(answer, answer.type === "answer" ? [answer.body.buffer] : []);
			port.close();
		};
		port.postMessage(FREE);
	});
}

let queue: { request: GrowRequest } | undefined;

async function loadQueue(): Promise<GrowRequest> {
	const { SpecimenQueue } = await import("./specimen_queue");
	queue ??= new SpecimenQueue();
	return queue.request.bind(queue);
}
