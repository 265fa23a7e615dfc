/**
 * The core under Vite: built before the page is served or bundled, and built again when its sources change. What does
 * not compile shows in the terminal and over the page, which keeps running on the last good core.
 */
import { join, sep } from "node:path";
import { buildCore } from "./core.mjs";
import { generate } from "./generate.mjs";
import { coreFolder } from "./repository.mjs";

const watched = ["src", "grammars", "parameters", "tools", "CMakeLists.txt", "CMakePresets.json"].map((name) =>
	join(coreFolder, name),
);
const settled = 60; // milliseconds in which an editor's several writes become one change

function isSource(path) {
	const ofCore = watched.some((place) => path === place || path.startsWith(place + sep));
	return ofCore && /\.(cpp|hpp|h|lsys|json|cmake|txt)$/.test(path);
}

/** Runs `work` after changes have settled; one run at a time, and one more if something changed meanwhile. */
function whenSettled(work) {
	let timer;
	let running = false;
	let again = false;
	const start = async () => {
		if (running) {
			again = true;
			return;
		}
		running = true;
		do {
			again = false;
			await work();
		} while (again);
		running = false;
	};
	return () => {
		clearTimeout(timer);
		timer = setTimeout(start, settled);
	};
}

/** Builds and tells the page: to load again, or what does not compile. */
async function rebuild(server, state) {
	const { logger } = server.config;
	const from = performance.now();
	try {
		generate({ write: true });
		const { changed } = await buildCore();
		const seconds = ((performance.now() - from) / 1000).toFixed(1);
		logger.info(`core ${changed ? "built" : "unchanged"} in ${seconds} s`, { timestamp: true });
		if (changed || state.failed) server.ws.send({ type: "full-reload" });
		state.failed = false;
	} catch (error) {
		state.failed = true;
		logger.error(`the core does not build; the page keeps the last one\n${error.message}`, { timestamp: true });
		server.ws.send({ type: "error", err: { message: error.message, stack: "", plugin: "core" } });
	}
}

/** Vite's own scripts write styles into the page; the built page never does. */
function forDevelopment(html) {
	return html.replace(/style-src 'self'/, "style-src 'self' 'unsafe-inline'");
}

/** @returns {import("vite").Plugin} */
export function core() {
	let serves = false;
	return {
		name: "core",
		configResolved(config) {
			serves = config.command === "serve";
		},
		async buildStart() {
			if (!serves) await buildCore();
		},
		async configureServer(server) {
			if (process.env.VITEST) return;
			const state = { failed: false };
			const change = whenSettled(() => rebuild(server, state));
			server.watcher.add(watched);
			server.watcher.on("all", (_event, path) => {
				if (isSource(path)) change();
			});
			await rebuild(server, state);
		},
		transformIndexHtml: (html) => (serves ? forDevelopment(html) : html),
	};
}
