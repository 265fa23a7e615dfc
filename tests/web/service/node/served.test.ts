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

/** The program by itself in an empty folder: it is one file. */
beforeAll(async () => {
	folder = await mkdtemp(join(tmpdir(), "panicle-service-"));
	const build = ["wasm-core/tools/service.mjs", "--build"];
	const program = execFileSync(process.execPath, build, { cwd: repository, encoding: "utf8" })
		.trim()
		.split("\n")
		.at(-1);
	await copyFile(program as string, join(folder, "service.mjs"));
	server = spawn(process.execPath, ["service.mjs", "--port", "0", "--threads", "1", "--seconds", "4"], { cwd: folder });
	base = await new Promise<string>((resolve, reject) => {
		server.stdout?.on("data", (data) => resolve(/http:\S+(?=specimens)/.exec(`${data}`)?.[0] ?? ""));
		server.on("close", (status) => reject(new Error(`ended with ${status}`)));
	});
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

it("heeds the tag, HEAD and refusals over HTTP", async () => {
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
	const slow = await fetch(`${base}specimens/tree/oak.stl?file-thickness=0.2`);
	expect([slow.status, await slow.text()]).toEqual([503, expect.stringContaining("more than 4 s")]);
	expect((await fetch(`${base}specimens/redcurrant.json?count=5`)).status).toBe(200);
});

it("survives what is no HTTP", async () => {
	const { port } = new URL(base);
	const answer = await new Promise<string>((resolve) => {
		const socket = connect(Number(port), "127.0.0.1", () => socket.end("GET http://[ HTTP/1.1\r\nhost: x\r\n\r\n"));
		let text = "";
		socket.on("data", (data) => {
			text += data;
		});
		socket.on("close", () => resolve(text));
	});
	expect(answer).toMatch(/^HTTP\/1\.1 400 /);
	expect((await fetch(`${base}health`)).status).toBe(200);
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
	expect(call("--port", "http")).toMatch(/^2 service: --port http: a number from 0 to 65535\n/);
	expect(call("--colour")).toMatch(/^2 service: Unknown option/);
});
