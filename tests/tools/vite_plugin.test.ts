import { EventEmitter } from "node:events";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { buildCore } from "../../wasm-core/tools/core.mjs";
import { coreFolder, moduleNames, repository } from "../../wasm-core/tools/repository.mjs";
import { core } from "../../wasm-core/tools/vite_plugin.mjs";

vi.mock("../../wasm-core/tools/core.mjs", () => ({ buildCore: vi.fn() }));
vi.mock("../../wasm-core/tools/generate/files.mjs", () => ({ generate: vi.fn() }));
vi.mock("node:fs", async (original) => ({
	...(await original<typeof import("node:fs")>()),
	existsSync: vi.fn(() => false),
}));

const build = vi.mocked(buildCore);
const source = join(coreFolder, "src/models/bunch/plan.cpp");

type Handler = (request: { url: string }, response: object, next: () => void) => Promise<void>;

/** The parts of Vite's server that the plugin uses: a watcher, a line to the page, a log, and the handling of requests. */
function fakeServer() {
	const watcher = Object.assign(new EventEmitter(), { add: vi.fn() });
	const logger = { info: vi.fn(), error: vi.fn() };
	const handlers: Handler[] = [];
	const ws = { send: vi.fn(), on: vi.fn() };
	return {
		watcher,
		ws,
		config: { logger },
		middlewares: { use: (handler: Handler) => handlers.push(handler) },
		handlers,
	};
}

type FakeServer = ReturnType<typeof fakeServer>;

/** Calls the plugin's hook for a server; Vite's own types need its whole server. */
const serve = (server: FakeServer) =>
	(core() as unknown as { configureServer(server: FakeServer): Promise<void> }).configureServer(server);

/** Requests an address; returns the status, 200 where the plugin passes the request on. */
async function request(server: FakeServer, url: string): Promise<number> {
	const response = { statusCode: 0, end: vi.fn() };
	let isPassedOn = false;
	await server.handlers[0]({ url }, response, () => {
		isPassedOn = true;
	});
	return isPassedOn ? 200 : response.statusCode;
}

/** A server whose modules are all built. */
async function serving() {
	const server = fakeServer();
	await serve(server);
	await settled();
	server.ws.send.mockClear();
	build.mockClear();
	return server;
}

/** A server whose modules are all built, but for that of the stand, which does not compile. */
async function servingWithoutStand() {
	const server = fakeServer();
	build.mockImplementation((_preset, targets) =>
		targets?.[0] === "stand"
			? Promise.reject(new Error("places.cpp:3: expected ;"))
			: Promise.resolve({ changed: true }),
	);
	await serve(server);
	await settled();
	return server;
}

const settled = () => vi.advanceTimersByTimeAsync(1000);

beforeEach(() => {
	vi.useFakeTimers();
	build.mockReset().mockResolvedValue({ changed: true });
	vi.mocked(existsSync).mockReset().mockReturnValue(false);
});
afterEach(() => {
	vi.useRealTimers();
});

it("serves the page when the bunch's core is built, and builds the others after that", async () => {
	const server = fakeServer();
	const others: (() => void)[] = [];
	build.mockImplementation((_preset, targets) =>
		targets?.[0] === "bunch"
			? Promise.resolve({ changed: true })
			: new Promise((resolve) => others.push(() => resolve({ changed: true }))),
	);
	await serve(server);
	await settled();
	expect(build.mock.calls[0]).toEqual(["wasm", ["bunch"]]);
	expect(others).toHaveLength(1);
	while (others.length > 0) {
		others.shift()?.();
		await settled();
	}
	expect(build.mock.calls.map(([, targets]) => targets?.[0]).sort()).toEqual(moduleNames());
	expect(server.watcher.add).toHaveBeenCalledWith(expect.arrayContaining([join(coreFolder, "grammars")]));
	expect(server.ws.send).not.toHaveBeenCalledWith({ type: "full-reload" });
});

it("holds a request for a module until it is built, and sends the page its state", async () => {
	const server = fakeServer();
	let finish = () => {};
	build.mockImplementation((_preset, targets) =>
		targets?.[0] === "stand"
			? new Promise((resolve) => (finish = () => resolve({ changed: true })))
			: Promise.resolve({ changed: true }),
	);
	await serve(server);
	await settled();
	let status = 0;
	request(server, "/@fs/panicle/build/core/stand.wasm").then((answer) => (status = answer));
	await settled();
	expect(status).toBe(0);
	const message = (state: string) => ({ type: "custom", event: "panicle:core", data: { model: "stand", state } });
	expect(server.ws.send).toHaveBeenLastCalledWith(message("building"));
	// A page that connects later gets the message, too.
	const [, connected] = server.ws.on.mock.calls.find(([event]) => event === "connection") ?? [];
	server.ws.send.mockClear();
	connected();
	expect(server.ws.send).toHaveBeenCalledWith(message("building"));
	finish();
	await settled();
	expect(status).toBe(200);
	expect(server.ws.send).toHaveBeenLastCalledWith(message("ready"));
});

it("serves the last module that compiled where the new one does not, and again the new one when it does", async () => {
	const server = await servingWithoutStand();
	const address = "/@fs/panicle/build/core/stand.wasm";
	expect(await request(server, address)).toBe(503);
	vi.mocked(existsSync).mockImplementation((path) => String(path).endsWith("stand.wasm"));
	expect(await request(server, address)).toBe(200);
});

it("answers with an error for a module that does not compile, and passes other requests on, malformed ones too", async () => {
	const server = await servingWithoutStand();
	expect(await request(server, "/@fs/panicle/build/core/stand.wasm")).toBe(503);
	expect(await request(server, "/@fs/panicle/build/core/bunch.wasm?import")).toBe(200);
	for (const url of ["/src/app/main.ts", "/%", "//", ""]) expect(await request(server, url)).toBe(200);
});

it("gives the page an address for every module, built or not, under the keys that the page uses", async () => {
	const plugin = core() as unknown as {
		configResolved(config: { command: string }): void;
		load(id: string): string | undefined;
		transformIndexHtml(html: string): { tags: { attrs: { src: string } }[] } | string;
	};
	plugin.configResolved({ command: "serve" });
	const code = plugin.load(join(repository, "web/src/core/core_files.ts")) ?? "";
	const files = JSON.parse(/= (\{.*\});$/.exec(code)?.[1] ?? "{}");
	const address = readFileSync(join(repository, "web/src/core/core_address.ts"), "utf8");
	const key = /coreFiles\[`(.*)\$\{file\}`\]/.exec(address)?.[1];
	expect(Object.keys(files)).toEqual(moduleNames().map((model) => `${key}${model}.wasm`));
	for (const model of moduleNames())
		expect(files[`${key}${model}.wasm`]).toMatch(new RegExp(`^/@fs/.*/build/core/${model}\\.wasm$`));
	const page = plugin.transformIndexHtml("<p>");
	const script = typeof page === "string" ? "" : page.tags[0].attrs.src;
	expect(readFileSync(script.replace("/@fs", ""), "utf8")).toContain("panicle:core");
	plugin.configResolved({ command: "build" });
	expect(plugin.load(join(repository, "web/src/core/core_files.ts"))).toBeUndefined();
	expect(plugin.transformIndexHtml("<p>")).toBe("<p>");
});

it("builds again and reloads the page when a source changes", async () => {
	const server = await serving();
	server.watcher.emit("all", "change", source);
	await settled();
	expect(build).toHaveBeenCalledTimes(1);
	expect(server.ws.send).toHaveBeenCalledWith({ type: "full-reload" });
});

it("builds once for several writes in a row, and not for files that are no source of the core", async () => {
	const server = await serving();
	for (const path of [source, source, join(coreFolder, "grammars/bunch/grape-bunch-3.lsys")]) {
		server.watcher.emit("all", "change", path);
	}
	await settled();
	expect(build).toHaveBeenCalledTimes(1);
	server.watcher.emit("all", "change", join(repository, "web/src/app/main.ts"));
	server.watcher.emit("all", "change", join(coreFolder, "src/models/bunch/plan.cpp.swp"));
	await settled();
	expect(build).toHaveBeenCalledTimes(1);
});

it.each(["flower/tulip.gl3", "growth/oak.growth", "stand/orchard.stand"])(
	"builds again when the grammar %s changes",
	async (path) => {
		const server = await serving();
		server.watcher.emit("all", "change", join(coreFolder, "grammars", path));
		await settled();
		expect(build).toHaveBeenCalledTimes(1);
	},
);

it("builds once more for what changed during a build", async () => {
	const server = await serving();
	let finish = () => {};
	build.mockImplementationOnce(() => new Promise((resolve) => (finish = () => resolve({ changed: true }))));
	server.watcher.emit("all", "change", source);
	await settled();
	server.watcher.emit("all", "change", source);
	server.watcher.emit("all", "unlink", source);
	await settled();
	expect(build).toHaveBeenCalledTimes(1);
	finish();
	await settled();
	expect(build).toHaveBeenCalledTimes(2);
});

it("does not reload the page when the core has not changed", async () => {
	const server = await serving();
	build.mockResolvedValueOnce({ changed: false });
	server.watcher.emit("all", "change", source);
	await settled();
	expect(server.ws.send).not.toHaveBeenCalled();
});

it("shows over the page what does not compile, and removes that when it compiles again", async () => {
	const server = await serving();
	build.mockRejectedValueOnce(new Error("plan.cpp:63: expected unqualified-id"));
	server.watcher.emit("all", "change", source);
	await settled();
	expect(server.ws.send).toHaveBeenCalledWith({
		type: "error",
		err: { message: "plan.cpp:63: expected unqualified-id", stack: "", plugin: "core" },
	});
	expect(server.config.logger.error).toHaveBeenCalled();
	build.mockResolvedValueOnce({ changed: false });
	server.watcher.emit("all", "change", source);
	await settled();
	expect(server.ws.send).toHaveBeenLastCalledWith({ type: "full-reload" });
});
