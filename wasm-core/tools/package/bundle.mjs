/**
 * The package's scripts: the library for browsers, workers and Node, and the element, each with the cores beside it.
 */
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { repository } from "../repository.mjs";
import { MODEL_RENDERER, MODEL_UI, without, withoutPreloading } from "../without_pages.mjs";

/** Records which packages of node_modules are part of the bundle. */
function noting(packages) {
	return {
		name: "noting-packages",
		generateBundle(_, bundle) {
			for (const { modules = {} } of Object.values(bundle)) {
				for (const id of Object.keys(modules)) {
					const name = /.*\/node_modules\/((?:@[^/]+\/)?[^/]+)\//.exec(id)?.[1];
					if (name) packages.add(name);
				}
			}
		},
	};
}

const source = (path) => join(repository, "web/src", path);

/**
 * @typedef {object} Bundle
 * @property {Record<string, string>} input its entries
 * @property {RegExp[]} left files of models' folders that are left out
 * @property {(string | RegExp)[]} [external] packages that are not in it
 * @property {object} output how its scripts are called
 * @property {false | "oxc"} minify
 */

/**
 * @param {Bundle} wanted
 * @param {string} folder
 * @param {Set<string>} packages receives the names of bundled third-party packages
 */
async function bundle({ input, left, external = [], output, minify }, folder, packages) {
	const { build } = await import("vite");
	await build({
		root: repository,
		configFile: false,
		publicDir: false,
		logLevel: "error",
		// The element reads it: there is no app beside the package (app_address.ts).
		mode: "package",
		// Every address is relative to the script that has it.
		base: "./",
		plugins: [without(...left), withoutPreloading, noting(packages)],
		worker: {
			format: "es",
			plugins: () => [without(MODEL_UI, MODEL_RENDERER), noting(packages)],
			// Bundlers copy a worker's script as it is: it must need no other.
			rolldownOptions: { output: { codeSplitting: false, entryFileNames: "workers/[name].js" } },
		},
		build: {
			outDir: folder,
			emptyOutDir: false,
			target: "es2022",
			assetsInlineLimit: 0,
			modulePreload: false,
			minify,
			rolldownOptions: {
				input,
				external,
				preserveEntrySignatures: "exports-only",
				output: { entryFileNames: "[name].js", assetFileNames: "cores/[name][extname]", ...output },
			},
		},
	});
}

/**
 * Writes all scripts and cores into a folder that is empty.
 * @returns {Promise<string>} the licences of the bundled third-party packages
 */
export async function bundlePackage(folder) {
	const packages = new Set();
	/** @type {Bundle} */
	const library = {
		input: {
			browser: source("library/browser.ts"),
			node: source("library/node.ts"),
			three: source("library/three.ts"),
			forest: source("library/forest/forest.ts"),
		},
		left: [MODEL_UI, MODEL_RENDERER],
		// The user of the package installs three; only the entry point for Node imports Node's modules.
		external: ["three", /^three\//, /^node:/],
		output: { chunkFileNames: "library/[name].js" },
		// Bundlers of the package's users minify it; unminified, its errors have readable lines.
		minify: false,
	};
	/** @type {Bundle} */
	const element = {
		input: { element: source("element/panicle.ts") },
		left: [MODEL_UI],
		output: {
			chunkFileNames: "element/[name].js",
			codeSplitting: { groups: [{ name: "three", test: /node_modules\/three\// }] },
		},
		minify: "oxc",
	};
	await bundle(library, folder, packages);
	await bundle(element, folder, packages);
	return [...packages].sort().map(licence).join("\n");
}

function licence(name) {
	const place = join(repository, "node_modules", name);
	const file = readdirSync(place).find((each) => /^licen[cs]e/i.test(each));
	const { version, license } = JSON.parse(readFileSync(join(place, "package.json"), "utf8"));
	const text = file ? readFileSync(join(place, file), "utf8").trim() : license;
	return `${name} ${version}\n\n${text}\n\n---\n`;
}
