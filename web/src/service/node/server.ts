/** The service as an HTTP server. */
import { createServer, type IncomingMessage, type Server, type ServerResponse } from "node:http";
import { messageOf } from "../../locale/message_error";
import { LONGEST_ADDRESS } from "../address";
import { text } from "../messages.generated";
import { ERROR_HEADERS, errorBody, Refused } from "../refused";
import { METHODS } from "../service";
import type { ThreadResponse } from "./messages";
import type { ThreadPool } from "./thread_pool";

/** Request headers on which an answer depends. */
const USED_HEADERS = ["if-none-match"] as const;
const HELP =
	"A specimen's file: /specimens/riesling.glb?seed=7, /specimens/NAME.json?v=2&… with a link's query. /health says ok.\n";

/** Limits on clients. Times in milliseconds. */
export interface ServerLimits {
	/** Open connections. */
	readonly connections: number;
	/** The time to receive a request's head, or the whole request. */
	readonly request: number;
	/** The time without reading after which a client's answer is dropped. */
	readonly stalled: number;
	/** Bytes per second below which an answer's average reading rate is too slow. */
	readonly slowest: number;
	/** Bytes of answers that clients have not read yet; above, further requests are refused. */
	readonly unread: number;
}

export const SERVER_LIMITS: ServerLimits = {
	connections: 1024,
	request: 10_000,
	stalled: 10_000,
	slowest: 64 * 1024,
	unread: 256 * 1024 * 1024,
};

/**
 * Creates the server. It limits connections, waiting times and unread answers; a body of a request is ignored.
 * @param threads answers the requests
 */
export function makeServer(threads: Pick<ThreadPool, "run">, limits = SERVER_LIMITS): Server {
	const options = {
		maxHeaderSize: LONGEST_ADDRESS + 8 * 1024,
		headersTimeout: limits.request,
		requestTimeout: limits.request,
		keepAliveTimeout: limits.request / 2,
		connectionsCheckingInterval: limits.request / 10,
	};
	// Bytes of answers that clients have not read yet: the limit keeps slow readers from filling the memory.
	let unread = 0;
	const server = createServer(options, async (request, response) => {
		request.socket.setTimeout(0); // Growing may take longer than clients may be idle.
		request.resume(); // Bodies are ignored.
		const { method = "GET", url = "/" } = request;
		if (url === "/" || url === "/health") return sendText(response, 200, url === "/" ? HELP : "ok\n");
		try {
			if (!METHODS.includes(method))
				throw new Refused(405, text.message("method_not_allowed", { method }), { allow: METHODS.join(", ") });
			if (unread > limits.unread) throw new Refused(503, text.message("too_many_unread"), { "retry-after": "5" });
			const left = leaving(response);
			const answer = await threads.run({ url: addressOf(url), method, headers: usedHeaders(request) }, left);
			if (left.aborted) return; // No “close” event follows that would count the answer as read.
			unread += answer.body.byteLength;
			response.once("close", () => {
				unread -= answer.body.byteLength;
			});
			// A server that is shutting down closes the connection after the answer.
			if (!server.listening) response.setHeader("connection", "close");
			send(response, answer, limits);
		} catch (error) {
			const refused = error instanceof Refused ? error : new Refused(400, text.message("unreadable_address"));
			sendText(response, refused.status, errorBody(messageOf(refused)), { ...ERROR_HEADERS, ...refused.headers });
		}
	});
	server.maxConnections = limits.connections;
	server.timeout = limits.request; // Closes connections that send nothing at all.
	return server;
}

/**
 * Returns the address in a request's first line, which may be a path or a whole address, without user name and
 * password.
 */
function addressOf(url: string): string {
	const address = new URL(url.startsWith("/") ? `http://localhost${url}` : url);
	address.username = "";
	address.password = "";
	return address.href;
}

/** Returns the headers of a request that the service uses. */
function usedHeaders(request: IncomingMessage): Record<string, string> {
	return Object.fromEntries(USED_HEADERS.flatMap((key) => (request.headers[key] ? [[key, request.headers[key]]] : [])));
}

/** Returns a signal that is aborted when the client closes the connection before its answer has been sent. */
function leaving(response: ServerResponse): AbortSignal {
	const controller = new AbortController();
	response.once("close", () => controller.abort());
	return controller.signal;
}

/** Sends an answer, and drops the connection of a client that reads too slowly. */
function send(response: ServerResponse, { status, headers, body }: ThreadResponse, limits: ServerLimits): void {
	const drop = () => void response.destroy();
	response.setTimeout(limits.stalled, drop);
	const deadline = setTimeout(drop, limits.stalled + (1000 * body.byteLength) / limits.slowest);
	response.once("close", () => clearTimeout(deadline));
	response.writeHead(status, headers).end(response.req.method === "HEAD" ? undefined : body);
}

/** Sends a plain text that is not cached. */
function sendText(
	response: ServerResponse,
	status: number,
	body: string,
	headers: Readonly<Record<string, string>> = {},
): void {
	const common = {
		"content-type": "text/plain; charset=utf-8",
		"cache-control": "no-store",
		"access-control-allow-origin": "*",
	};
	response.writeHead(status, { ...common, ...headers }).end(body);
}
