import { type ChildProcess, execFileSync, spawn } from "node:child_process";
import { copyFile, mkdtemp, readdir, rm } from "node:fs/promises";
import { connect } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { afterAll, beforeAll, expect, it } from "vitest";
import { isLongRun } from "../../../long_run.mjs";
import { grow } from "../../cli/world";

const repository = fileURLToPath(new URL("../../../../", import.meta.url));
let folder: string;
let server: ChildProcess;
let base: string;

/** Starts the program on a free port, with one thread. @param seconds that it has for a plant */
async function start(seconds = 60) {
	const program = ["service.mjs", "--port", "0", "--threads", "1", "--seconds", `${seconds}`];
	const service = spawn(process.execPath, program, { cwd: folder });
	const ended = new Promise<number | null>((resolve) => service.on("close", resolve));
	const address = new Promise<string>((resolve, reject) => {
		service.stdout.on("data", (data) => resolve(/http:\S+(?=specimens)/.exec(`${data}`)?.[0] ?? ""));
		void ended.then((status) => reject(new Error(`ended with ${status}`)));
	});
	return { process: service, ended, base: await address };
}

/** The program by itself in an empty folder: it is one file. */
beforeAll(async () => {
	folder = await mkdtemp(join(tmpdir(), "panicle-service-"));
	const build = ["wasm-core/tools/service.mjs", "--build"];
	const program = execFileSync(process.execPath, build, { cwd: repository, encoding: "utf8" })
		.trim()
		.split("\n")
		.at(-1);
	await copyFile(program as string, join(folder, "service.mjs"));
	({ process: server, base } = await start());
});
afterAll(async () => {
	server?.kill();
	await rm(folder, { recursive: true, force: true });
});

it("answers from one file, on loopback, with every model's plants", async () => {
	expect(await readdir(folder)).toEqual(["service.mjs"]);
	expect(base).toMatch(/^http:\/\/127\.0\.0\.1:\d+\/$/);
	expect(await (await fetch(`${base}health`)).text()).toBe("ok\n");
	const answer = await fetch(`${base}specimens/redcurrant.json?count=5&seed=3`);
	const { json } = await grow(["redcurrant", "--set", "count=5", "--seed", "3"]);
	expect(await answer.json()).toEqual({ ...json, timings: { grow: 0 } });
	const root = await fetch(`${base}specimens/root/carrot.glb?n=200`);
	expect(new TextDecoder().decode((await root.arrayBuffer()).slice(0, 4))).toBe("glTF");
});

it("answers tags, HEAD and refusals over HTTP", async () => {
	const address = `${base}specimens/redcurrant.json?count=5`;
	const first = await fetch(address);
	const tag = first.headers.get("etag") as string;
	const again = await fetch(address, { headers: { "if-none-match": tag } });
	expect([again.status, await again.text()]).toEqual([304, ""]);
	const head = await fetch(address, { method: "HEAD" });
	expect([head.status, head.headers.get("content-length"), await head.text()]).toEqual([
		200,
		`${(await first.arrayBuffer()).byteLength}`,
		"",
	]);
	const picture = await fetch(`${base}specimens/riesling.png`);
	expect([picture.status, await picture.text()]).toEqual([501, expect.stringContaining("graphics")]);
	expect((await fetch(`${base}specimens/riesling.glb`, { method: "PUT", body: "x" })).status).toBe(405);
});

it.runIf(isLongRun)("gives up a plant that takes too long, and grows the next", async () => {
	const { base: own, process: service } = await start(4);
	const slow = await fetch(`${own}specimens/tree/oak.stl?file-thickness=0.2`);
	expect([slow.status, await slow.text()]).toEqual([503, expect.stringContaining("longer than 4 s")]);
	expect((await fetch(`${own}specimens/redcurrant.json?count=5`)).status).toBe(200);
	service.kill();
});

/** The answer to one line of HTTP, sent over a raw connection. */
function answerTo(line: string): Promise<string> {
	const { port } = new URL(base);
	return new Promise((resolve) => {
		const request = `${line} HTTP/1.1\r\nhost: x\r\nconnection: close\r\n\r\n`;
		const socket = connect(Number(port), "127.0.0.1", () => socket.write(request));
		let text = "";
		socket.on("data", (data) => {
			text += data;
		});
		socket.on("close", () => resolve(text));
	});
}

it("answers malformed requests with an error, and goes on", async () => {
	expect(await answerTo("GET http://[")).toMatch(/^HTTP\/1\.1 400 /);
	expect(await answerTo("TRACE /specimens/redcurrant.json?count=5")).toMatch(/^HTTP\/1\.1 405 /);
	expect(await answerTo("GET //u:p@h/specimens/redcurrant.json?count=5")).toMatch(/^HTTP\/1\.1 200 /);
	expect((await fetch(`${base}health`)).status).toBe(200);
});

it("answers a small request soon after fifteen clients with large ones have left", async () => {
	const heavy = `${base}specimens/tree/oak.stl?file-thickness=0.2`;
	const clients = Array.from({ length: 15 }, () => new AbortController());
	const left = clients.map(({ signal }, n) => fetch(`${heavy}&seed=${n}`, { signal }).catch(() => undefined));
	// The first of them grows by then, the others wait.
	await fetch(`${base}health`);
	for (const client of clients) client.abort();
	await Promise.all(left);
	// Fifteen such plants, one after the other, would take longer than a request may wait.
	expect((await fetch(`${base}specimens/redcurrant.json?count=5`)).status).toBe(200);
});

it.runIf(isLongRun)("answers or refuses each of 100 large requests at once", async () => {
	const { base: own, process: service } = await start(4);
	const answers = Array.from({ length: 100 }, (_, n) => fetch(`${own}specimens/tree/oak.glb?seed=${n}`));
	const health = await fetch(`${own}health`);
	expect(health.status).toBe(200);
	const statuses = await Promise.all(
		answers.map(async (answering) => {
			const answer = await answering;
			const { byteLength } = await answer.arrayBuffer();
			expect(byteLength).toBeGreaterThan(0);
			return answer.status;
		}),
	);
	expect(new Set(statuses)).toEqual(new Set([200, 503]));
	service.kill();
});

it("answers what it has begun when it is ended by SIGTERM, and refuses the rest", async () => {
	const { ended, base: own, process: service } = await start();
	const growing = fetch(`${own}specimens/tree/oak.glb`);
	// The request has come by the time that another one is answered.
	await fetch(`${own}health`);
	service.kill("SIGTERM");
	const answer = await growing;
	expect([answer.status, answer.headers.get("connection")]).toEqual([200, "close"]);
	expect((await answer.arrayBuffer()).byteLength).toBeGreaterThan(0);
	expect(await ended).toBe(0);
	await expect(fetch(`${own}health`)).rejects.toThrow();
});

it("refuses options that it does not know", () => {
	const call = (...words: string[]) => {
		try {
			execFileSync(process.execPath, [join(folder, "service.mjs"), ...words], { stdio: "pipe" });
			return "";
		} catch (error) {
			return `${(error as { status: number }).status} ${(error as { stderr: Buffer }).stderr}`;
		}
	};
	expect(call("--port", "http")).toMatch(/^2 service: --port http: use a number from 0 to 65535\.\n/);
	expect(call("--colour")).toMatch(/^2 service: Unknown option/);
});
