/** The service as a server of HTTP. */
import { createServer, type IncomingMessage, type Server, type ServerResponse } from "node:http";
import { LONGEST_ADDRESS } from "../address";
import { Refused } from "../refused";
import type { Threads } from "./threads";

/** What a plant depends on besides its address. */
const HEEDED = ["if-none-match"] as const;
const HELP =
	"A specimen's file: /specimens/riesling.glb?seed=7, /specimens/NAME.json?v=2&… with a link's query. /health says ok.\n";

export function makeServer(threads: Pick<Threads, "ask">): Server {
	const server = createServer({ maxHeaderSize: LONGEST_ADDRESS + 8 * 1024 }, (request, response) => {
		void answer(threads, request, response);
	});
	// Who sends a request's head slowly must not keep others out.
	server.headersTimeout = 10_000;
	server.requestTimeout = 10_000;
	return server;
}

async function answer(
	threads: Pick<Threads, "ask">,
	request: IncomingMessage,
	response: ServerResponse,
): Promise<void> {
	request.resume(); // A body is none of ours.
	const { method = "GET", url = "/" } = request;
	if (url === "/" || url === "/health") return say(response, 200, url === "/" ? HELP : "ok\n");
	const headers = Object.fromEntries(
		HEEDED.flatMap((key) => (request.headers[key] ? [[key, request.headers[key]]] : [])),
	);
	try {
		const reply = await threads.ask({ url: new URL(url, "http://localhost").href, method, headers });
		response.writeHead(reply.status, reply.headers).end(method === "HEAD" ? undefined : reply.body);
	} catch (error) {
		const refused = error instanceof Refused ? error : new Refused(400, "this is no address");
		say(response, refused.status, `${refused.message}\n`, refused.headers);
	}
}

function say(
	response: ServerResponse,
	status: number,
	text: string,
	headers: Readonly<Record<string, string>> = {},
): void {
	const common = {
		"content-type": "text/plain; charset=utf-8",
		"cache-control": "no-store",
		"access-control-allow-origin": "*",
	};
	response.writeHead(status, { ...common, ...headers }).end(text);
}
