import { EventEmitter } from "node:events";
import { join } from "node:path";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { buildCore } from "../../wasm-core/tools/core.mjs";
import { coreFolder, repository } from "../../wasm-core/tools/repository.mjs";
import { core } from "../../wasm-core/tools/vite_plugin.mjs";

vi.mock("../../wasm-core/tools/core.mjs", () => ({ buildCore: vi.fn() }));
vi.mock("../../wasm-core/tools/generate.mjs", () => ({ generate: vi.fn() }));

const build = vi.mocked(buildCore);
const source = join(coreFolder, "src/models/bunch/plan.cpp");

/** What the plugin sees of Vite's server: a watcher, a line to the page and a log. */
function fakeServer() {
	const watcher = Object.assign(new EventEmitter(), { add: vi.fn() });
	const logger = { info: vi.fn(), error: vi.fn() };
	return { watcher, ws: { send: vi.fn() }, config: { logger } };
}

/** The plugin's one hook that matters here; Vite's own types ask for its whole server. */
const serve = (server: object) =>
	(core() as unknown as { configureServer(server: object): Promise<void> }).configureServer(server);

/** The plugin at work on a server whose first build is done. */
async function serving() {
	const server = fakeServer();
	await serve(server);
	server.ws.send.mockClear();
	build.mockClear();
	return server;
}

const settled = () => vi.advanceTimersByTimeAsync(1000);

beforeEach(() => {
	vi.useFakeTimers();
	vi.stubEnv("VITEST", "");
	build.mockReset().mockResolvedValue({ changed: true });
});
afterEach(() => {
	vi.useRealTimers();
	vi.unstubAllEnvs();
});

it("builds before the page is served", async () => {
	const server = fakeServer();
	await serve(server);
	expect(build).toHaveBeenCalledTimes(1);
	expect(server.watcher.add).toHaveBeenCalledWith(expect.arrayContaining([join(coreFolder, "grammars")]));
});

it("builds again and loads the page again when a source changes", async () => {
	const server = await serving();
	server.watcher.emit("all", "change", source);
	await settled();
	expect(build).toHaveBeenCalledTimes(1);
	expect(server.ws.send).toHaveBeenCalledWith({ type: "full-reload" });
});

it("builds once for several writes in a row, and not for what is no source of the core", async () => {
	const server = await serving();
	for (const path of [source, source, join(coreFolder, "grammars/bunch/grape-bunch-3.lsys")]) {
		server.watcher.emit("all", "change", path);
	}
	await settled();
	expect(build).toHaveBeenCalledTimes(1);
	server.watcher.emit("all", "change", join(repository, "web/src/studio/main.ts"));
	server.watcher.emit("all", "change", join(coreFolder, "src/models/bunch/plan.cpp.swp"));
	await settled();
	expect(build).toHaveBeenCalledTimes(1);
});

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

it("leaves the page alone when the core came out the same", async () => {
	const server = await serving();
	build.mockResolvedValueOnce({ changed: false });
	server.watcher.emit("all", "change", source);
	await settled();
	expect(server.ws.send).not.toHaveBeenCalled();
});

it("shows what does not compile over the page, and clears it when that is mended", async () => {
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
