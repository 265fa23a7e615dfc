import { once } from "node:events";
import type { Server } from "node:http";
import { type AddressInfo, connect, type Socket } from "node:net";
import { afterEach, expect, it, vi } from "vitest";
import type { ThreadResponse } from "../../../../web/src/service/node/messages";
import { makeServer, SERVER_LIMITS } from "../../../../web/src/service/node/server";
import type { ThreadPool } from "../../../../web/src/service/node/thread_pool";

// A request that is never answered fails its test soon.
vi.setConfig({ testTimeout: 10_000 });

/** Limits with which a test takes no longer than a second. */
const LIMITS = { ...SERVER_LIMITS, request: 200, stalled: 200, unread: 1000 };
const LARGE = 64 * 1024 * 1024;

let server: Server;
afterEach(() => {
	server.closeAllConnections();
	server.close();
});

async function serve(run: ThreadPool["run"], limits = LIMITS): Promise<void> {
	server = makeServer({ run }, limits).listen(0, "127.0.0.1");
	await once(server, "listening");
}

/** A raw connection, so that no HTTP client corrects the request. */
function send(text: string): Socket {
	const { port } = server.address() as AddressInfo;
	const socket = connect(port, "127.0.0.1", () => socket.write(text));
	return socket.on("error", () => {});
}

const request = (address: string, method = "GET") =>
	`${method} ${address} HTTP/1.1\r\nhost: x\r\nconnection: close\r\n\r\n`;

const closed = (socket: Socket) => new Promise<unknown>((resolve) => socket.once("close", resolve));

/** All that a connection answers until it closes. */
async function answerOf(socket: Socket): Promise<string> {
	let text = "";
	socket.on("data", (data) => {
		text += data;
	});
	await closed(socket);
	return text;
}

const answer = (bytes: number): ThreadResponse => ({
	id: 1,
	status: 200,
	headers: {},
	body: new Uint8Array(bytes),
	heapBytes: 0,
});

it("passes on addresses of every form without a user and password, and refuses methods that it does not answer", async () => {
	const run = vi.fn<ThreadPool["run"]>(async () => answer(2));
	await serve(run);
	const addresses = [
		"//u:p@h/specimens/riesling.json",
		"http://u:p@h/specimens/riesling.json",
		"/specimens/a.json?x=//",
	];
	for (const address of addresses) expect(await answerOf(send(request(address)))).toMatch(/^HTTP\/1\.1 200 /);
	expect(run.mock.calls.map(([{ url }]) => url)).toEqual([
		"http://localhost//u:p@h/specimens/riesling.json",
		"http://h/specimens/riesling.json",
		"http://localhost/specimens/a.json?x=//",
	]);
	for (const method of ["TRACE", "PUT", "PROPFIND"])
		expect(await answerOf(send(request("/specimens/riesling.json", method)))).toMatch(
			/^HTTP\/1\.1 405 [\s\S]*allow: GET/i,
		);
	expect(await answerOf(send(request("http://[/", "GET")))).toMatch(/^HTTP\/1\.1 400 /);
	expect(run).toHaveBeenCalledTimes(3);
});

it("aborts the request of a client that has left", async () => {
	let socket: Socket | undefined;
	let aborted: Promise<unknown> | undefined;
	await serve((_, signal) => {
		aborted = signal && once(signal, "abort");
		socket?.destroy();
		return new Promise(() => {});
	});
	socket = send(request("/specimens/riesling.json"));
	await closed(socket);
	await aborted;
	expect(aborted).toBeDefined();
});

it("drops an answer that is not read, and meanwhile refuses further requests", async () => {
	await serve(async () => answer(LARGE));
	const stalled = send(request("/specimens/riesling.glb"));
	stalled.pause();
	await once(stalled, "connect");
	await vi.waitFor(async () =>
		expect(await answerOf(send(request("/specimens/other.glb")))).toMatch(/^HTTP\/1\.1 503 [\s\S]*retry-after: 5/i),
	);
	await vi.waitFor(async () => expect(await connections()).toBe(0), { timeout: 5000 });
});

it("forgets the answer to a client that left before it was ready", async () => {
	const run = vi.fn<ThreadPool["run"]>(async () => answer(2));
	let socket: Socket | undefined;
	run.mockImplementationOnce(async (_, signal) => {
		const left = signal && once(signal, "abort");
		socket?.destroy();
		await left;
		return answer(2 * LIMITS.unread);
	});
	await serve(run);
	socket = send(request("/specimens/riesling.glb"));
	await closed(socket);
	await vi.waitFor(async () => expect(await connections()).toBe(0));
	expect(await answerOf(send(request("/specimens/other.glb")))).toMatch(/^HTTP\/1\.1 200 /);
});

it("drops an answer that is read too slowly over all", async () => {
	await serve(async () => answer(LARGE), { ...LIMITS, stalled: 500, slowest: 4 * LARGE });
	const slow = send(request("/specimens/riesling.glb"));
	// A megabyte each 40 ms never stalls, and takes 2.5 s for all.
	let allowed = 0;
	slow.on("data", () => slow.bytesRead > allowed && slow.pause());
	const reading = setInterval(() => {
		allowed += 2 ** 20;
		slow.resume();
	}, 40);
	await closed(slow);
	clearInterval(reading);
	expect(slow.bytesRead).toBeLessThan(LARGE);
});

it("closes connections that send no request, or one that never ends", async () => {
	await serve(async () => answer(2));
	const idle = [send(""), send("GET /specimens/"), send("GET / HTTP/1.1\r\nhost: x\r\nx: ")];
	await Promise.all(idle.map(closed));
});

it("refuses a flood of headers, and answers the next request", async () => {
	await serve(async () => answer(2));
	const flood = `GET /specimens/riesling.json HTTP/1.1\r\nhost: x\r\n${"x: y\r\n".repeat(20_000)}\r\n`;
	expect(await answerOf(send(flood))).toMatch(/^HTTP\/1\.1 431 /);
	expect(await answerOf(send(request("/health")))).toMatch(/^HTTP\/1\.1 200 /);
});

it("opens no more connections than it may", async () => {
	await serve(async () => answer(2), { ...LIMITS, connections: 2, request: 5000 });
	const open = [send(""), send("")];
	await Promise.all(open.map((socket) => once(socket, "connect")));
	await closed(send(request("/health")));
	expect(await connections()).toBe(2);
});

function connections(): Promise<number> {
	return new Promise((resolve) => server.getConnections((_, count) => resolve(count)));
}
