/**
 * Delegates the growth of specimens from the service worker to an open page: the service worker's own thread also
 * serves the app's files, and cannot end a growth.
 */
import { CANCEL, FREE, GROWTH_NEEDED, type SpecimenAnswer, type SpecimenRequest } from "./messages";

/** A page, as the service worker sees it. */
export interface PageClient {
	postMessage(message: unknown, transfer: Transferable[]): void;
}

/** Milliseconds in which a page must reply that it grows specimens. */
const PATIENCE = 250;
/** Milliseconds in which a page must answer a request: longer than its full queue takes (SpecimenQueue). */
const LONGEST = 600_000;

export interface PageGrowthOptions {
	/** Cancels the growth in the page: the promise rejects with the signal's reason. */
	readonly signal?: AbortSignal;
	readonly patience?: number;
	readonly longest?: number;
}

/**
 * Sends the request to the first page that replies that it can grow specimens.
 * @returns undefined if no page can
 */
export async function grownByPage(
	pages: readonly PageClient[],
	request: SpecimenRequest,
	{ signal, patience = PATIENCE, longest = LONGEST }: PageGrowthOptions = {},
): Promise<Response | undefined> {
	const port = await firstFree(pages, patience);
	if (!port) return undefined;
	const cancel = () => port.postMessage(CANCEL);
	const answer = await new Promise<SpecimenAnswer>((resolve) => {
		const give = (data: SpecimenAnswer) => {
			clearTimeout(timer);
			resolve(data);
		};
		const timer = setTimeout(give, longest, { type: "unable" });
		port.onmessage = ({ data }: MessageEvent<SpecimenAnswer>) => give(data);
		// The page was closed.
		port.addEventListener("close", () => give({ type: "unable" }));
		port.postMessage(request);
		if (signal?.aborted) cancel();
		else signal?.addEventListener("abort", cancel);
	});
	signal?.removeEventListener("abort", cancel);
	port.close();
	signal?.throwIfAborted();
	return answer.type === "answer" ? responseOf(answer) : undefined;
}

/** HTTP statuses without a body. */
const EMPTY = [204, 304];

/** Converts a page's answer to a response. */
export function responseOf({ status, headers, body }: Extract<SpecimenAnswer, { type: "answer" }>): Response {
	return new Response(EMPTY.includes(status) ? null : body, { status, headers });
}

/** Returns the port of the first page that replies; closes the ports of the others. */
function firstFree(pages: readonly PageClient[], patience: number): Promise<MessagePort | undefined> {
	return new Promise((resolve) => {
		const ports: MessagePort[] = [];
		const timer = setTimeout(() => settle(undefined), pages.length > 0 ? patience : 0);
		const settle = (free: MessagePort | undefined) => {
			clearTimeout(timer);
			for (const port of ports) if (port !== free) port.close();
			resolve(free);
		};
		for (const page of pages) {
			const { port1, port2 } = new MessageChannel();
			ports.push(port1);
			port1.onmessage = ({ data }: MessageEvent<unknown>) => data === FREE && settle(port1);
			page.postMessage(GROWTH_NEEDED, [port2]);
		}
	});
}
