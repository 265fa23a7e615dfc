/**
 * The core under Vite. `vite build` builds all modules first. The development server builds the bunch's module, serves
 * the page, and builds the others in the background, the one that a page requests next; it builds again when sources of
 * the core change. What does not compile shows in the terminal and over the page, which keeps the last good core.
 */
import { existsSync } from "node:fs";
import { join, sep } from "node:path";
import { buildCore } from "./core.mjs";
import { CoreQueue } from "./core_queue.mjs";
import { generate } from "./generate/files.mjs";
import { coreFolder, moduleNames, moduleOf, repository } from "./repository.mjs";

const watched = ["src", "grammars", "parameters", "tools", "CMakeLists.txt", "CMakePresets.json"].map((name) =>
	join(coreFolder, name),
);
/** Milliseconds in which an editor's several writes become one change. */
const SETTLED = 60;
/** The module that the page opens with. */
const FIRST = "bunch";
/** The module of web/src that knows the addresses of the built modules. */
const ADDRESSES = "/web/src/core/core_files.ts";

const isSource = (path) =>
	watched.some((place) => path === place || path.startsWith(place + sep)) &&
	/\.(cpp|hpp|h|lsys|growth|gl3|stand|json|cmake|txt)$/.test(path);

/** Runs `work` after changes have settled; one run at a time, and one more if something changed meanwhile. */
function whenSettled(work) {
	let timer;
	let isRunning = false;
	let isDue = false;
	/** Runs `work`, and again as long as changes arrive meanwhile. */
	const start = async () => {
		if (isRunning) {
			isDue = true;
			return;
		}
		isRunning = true;
		do {
			isDue = false;
			await work();
		} while (isDue);
		isRunning = false;
	};
	return () => {
		clearTimeout(timer);
		timer = setTimeout(start, SETTLED);
	};
}

/**
 * Builds modules of the core and informs the page: to reload, or of what does not compile.
 * @param server Vite's development server
 * @param state `hasFailed`: whether the last build failed; `isServing`: whether the module that the page opens with is
 * built
 * @param targets names of the modules to build; empty for all
 * @returns whether the modules were built
 */
async function build(server, state, targets) {
	const { logger } = server.config;
	const startTime = performance.now();
	try {
		const { changed } = await buildCore("wasm", targets);
		const seconds = ((performance.now() - startTime) / 1000).toFixed(1);
		const builtName = targets.length > 0 ? `core of ${targets.join(", ")}` : "core";
		logger.info(`${builtName} ${state.isServing && !changed ? "unchanged" : "ready"} after ${seconds} s`, {
			timestamp: true,
		});
		// Single modules are built at the start, and requests for them wait (`holdRequests`): the page needs no reload. After
		// a failure the reload also removes the error from the page.
		if (state.isServing && targets.length === 0 && (changed || state.hasFailed))
			server.ws.send({ type: "full-reload" });
		state.hasFailed = false;
		return true;
	} catch (error) {
		state.hasFailed = true;
		logger.error(`The core does not compile; the page keeps the last one.\n${error.message}`, { timestamp: true });
		server.ws.send({ type: "error", err: { message: error.message, stack: "", plugin: "core" } });
		return false;
	}
}

/**
 * Holds a request for a module until the module is built. Where it does not compile, the last one that did is served,
 * or an error where there is none.
 */
function holdRequests(server, queue) {
	server.middlewares.use(async (request, response, next) => {
		const model = /\/build\/core\/(\w+)\.wasm(?:\?|$)/.exec(request.url ?? "")?.[1];
		if (!model || (await queue.wait(model)) || existsSync(moduleOf(model))) return next();
		response.statusCode = 503;
		response.end(`The core of ${model} does not compile; see the terminal.`);
	});
}

/**
 * Builds the cores in the background and again after changes; resolves once the first one is built, with which the page
 * opens.
 */
async function serveCore(server) {
	const state = { hasFailed: false, isServing: false };
	const models = moduleNames().sort((a, b) => Number(b === FIRST) - Number(a === FIRST));
	const send = (model, status) =>
		server.ws.send({ type: "custom", event: "panicle:core", data: { model, state: status } });
	const queue = new CoreQueue(models, (model) => build(server, state, [model]), send);
	// A page that has just connected may have missed the first message.
	server.ws.on("connection", () => {
		for (const model of queue.requested) send(model, "building");
	});
	holdRequests(server, queue);
	const initialBuilds = queue.run();
	server.watcher.add(watched);
	const change = whenSettled(async () => {
		await initialBuilds;
		server.config.logger.info("building the core …", { timestamp: true });
		generate();
		await build(server, state, []);
	});
	server.watcher.on("all", (_event, path) => {
		if (isSource(path)) change();
	});
	await queue.wait(FIRST);
	state.isServing = true;
}

/** The address under which Vite serves a file of the repository, whatever the root of the page. */
const served = (file) => join("/@fs/", file).replaceAll(sep, "/");

/**
 * core_files.ts for the development server: the addresses of all modules, built or not. The file itself lists those
 * that Vite finds on disk.
 */
function plannedAddresses() {
	const addresses = moduleNames().map((model) => [`../../../build/core/${model}.wasm`, served(moduleOf(model))]);
	return `export const coreFiles = ${JSON.stringify(Object.fromEntries(addresses))};`;
}

/**
 * Adapts the page to the development server, whose own scripts write styles into it and whose modules may be missing.
 */
const forDevelopment = (html) => ({
	html: html.replace(/style-src 'self'/, "style-src 'self' 'unsafe-inline'"),
	tags: [
		{
			tag: "script",
			attrs: { type: "module", src: served(join(repository, "web/dev/core_status.ts")) },
			injectTo: "head",
		},
	],
});

/**
 * Creates the plugin.
 * @returns {import("vite").Plugin}
 */
export function core() {
	let isServer = false;
	let isBuild = false;
	return {
		name: "core",
		configResolved(config) {
			isServer = config.command === "serve";
			isBuild = config.command === "build";
		},
		async buildStart() {
			if (isBuild) await buildCore();
		},
		async configureServer(server) {
			await serveCore(server);
		},
		load: (id) => (isServer && id.endsWith(ADDRESSES) ? plannedAddresses() : undefined),
		transformIndexHtml: (html) => (isServer ? /** @type {any} */ (forDevelopment(html)) : html),
	};
}
