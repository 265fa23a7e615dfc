import { createHash } from "node:crypto";
import { readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { MODEL_RENDERER, MODEL_UI, without, withoutPreloading } from "../wasm-core/tools/without_pages.mjs";
import { DOCS } from "./docs_site.mjs";
import { HANDS } from "./hands_files.mjs";

const SCRIPT = "service-worker.js";
const source = (name) => fileURLToPath(new URL(`src/offline/${name}.ts`, import.meta.url));
const version = () => JSON.parse(readFileSync(new URL("../package.json", import.meta.url), "utf8")).version;
const digest = (bytes) => createHash("sha256").update(bytes).digest();

/** Bundles a module with all its static and dynamic imports into one script without exports. */
async function bundle(name, define = {}) {
	const { build } = await import("vite");
	const built = await build({
		configFile: false,
		publicDir: false,
		logLevel: "error",
		define,
		plugins: [without(MODEL_UI, MODEL_RENDERER), withoutPreloading],
		build: {
			write: false,
			target: "es2022",
			modulePreload: false,
			rolldownOptions: { input: source(name), output: { format: "iife", codeSplitting: false } },
		},
	});
	return built.output[0].code;
}

/**
 * Lists the files of a folder of the built app: `integrity` by path, the page itself as "", in alphabetical order. The files for hand
 * tracking are left out, which only the camera needs and which are larger than all others together, and so is the documentation.
 * @param {string} folder
 */
export function listFiles(folder) {
	const paths = readdirSync(folder, { recursive: true, withFileTypes: true })
		.filter((entry) => entry.isFile())
		.map(({ parentPath, name }) =>
			join(parentPath, name)
				.slice(folder.length + 1)
				.replaceAll("\\", "/"),
		)
		.filter((path) => ![HANDS, DOCS].includes(path.split("/")[0]))
		.sort();
	const integrity = (path) => `sha256-${digest(readFileSync(join(folder, path))).toString("base64")}`;
	return Object.fromEntries(paths.map((path) => [path === "index.html" ? "" : path, integrity(path)]));
}

/**
 * Writes the service worker into the built app, with the list of all files, and the script that responds to requests for specimens.
 *
 * @returns {import("vite").Plugin}
 */
export function offlineApp() {
	return {
		name: "offline-app",
		apply: "build",
		async writeBundle({ dir }, output) {
			const cores = Object.values(output)
				.filter(({ fileName }) => fileName.endsWith(".wasm"))
				.map((asset) => [asset.type === "asset" ? asset.names[0] : "", asset.fileName]);
			// The browser stores the worker and its script itself: they are not in the list.
			const files = listFiles(dir);
			const answering = await bundle("specimens");
			const specimens = `assets/specimens-${digest(answering).toString("base64url").slice(0, 8)}.js`;
			const id = digest(JSON.stringify([files, specimens]))
				.toString("hex")
				.slice(0, 16);
			const built = { release: version(), id, files, cores: Object.fromEntries(cores), specimens };
			writeFileSync(join(dir, specimens), answering);
			writeFileSync(join(dir, SCRIPT), await bundle("service_worker", { __BUILT__: JSON.stringify(built) }));
		},
	};
}
