/** Specimens that the service worker has a page grow: its own thread answers for the app's files, too, and cannot end a growth. */
import { FREE, GROWTH_NEEDED, type SpecimenAnswer, type SpecimenRequest } from "./messages";

/** A page, as the service worker sees it. */
export interface PageClient {
	postMessage(message: unknown, transfer: Transferable[]): void;
}

/** So long a page may take to say that it grows specimens, milliseconds. */
const PATIENCE = 250;
/** A page that has taken a request has answered by then, milliseconds: what waits there at the most takes less (SpecimenQueue). */
const LONGEST = 600_000;

/**
 * Has the first page that says it can grow a specimen do so.
 * @returns undefined where none can
 */
export async function grownByPage(
	pages: readonly PageClient[],
	request: SpecimenRequest,
	{ patience = PATIENCE, longest = LONGEST } = {},
): Promise<Response | undefined> {
	const port = await firstFree(pages, patience);
	if (!port) return undefined;
	const answer = await new Promise<SpecimenAnswer>((resolve) => {
		const give = (data: SpecimenAnswer) => {
			clearTimeout(timer);
			resolve(data);
		};
		const timer = setTimeout(give, longest, { type: "unable" });
		port.onmessage = ({ data }: MessageEvent<SpecimenAnswer>) => give(data);
		// The page has been left.
		port.addEventListener("close", () => give({ type: "unable" }));
		port.postMessage(request);
	});
	port.close();
	return answer.type === "answer" ? responseOf(answer) : undefined;
}

/** Statuses of HTTP that have no body. */
const EMPTY = [204, 304];

export function responseOf({ status, headers, body }: Extract<SpecimenAnswer, { type: "answer" }>): Response {
	return new Response(EMPTY.includes(status) ? null : body, { status, headers });
}

/** The port of the page that was first to say so; those of others are closed. */
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
