/**
 * Measures the downloads of users: the built app (dist/), the cores, the package and the leaves that are drawn on plants. Rows that only a browser
 * can measure, such as the first load, are measured by the end-to-end tests (expect_size.ts), and read from the files that these write.
 */
import { createHash } from "node:crypto";
import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { dirname, join, posix } from "node:path";
import { buildFolder, moduleNames, moduleOf, repository } from "../../wasm-core/tools/repository.mjs";
import { emscriptenIdentity, locate } from "../../wasm-core/tools/toolchain.mjs";
import { listFiles } from "../../web/offline_app.mjs";
import { gzipped } from "../bench/sizes.mjs";

const dist = join(repository, "dist");
const leaves = join(repository, "web/src/plant/leaves");
/** A file for each row that a browser has measured. */
const measuredFolder = join(buildFolder, "sizes");

const sizeOf = (path) => statSync(path).size;
const sum = (numbers) => numbers.reduce((total, each) => total + each, 0);
const filesBelow = (folder) =>
	readdirSync(folder, { recursive: true, withFileTypes: true })
		.filter((entry) => entry.isFile())
		.map(({ parentPath, name }) => join(parentPath, name));

/** The one script of that name in dist/assets. */
function asset(name) {
	const found = readdirSync(join(dist, "assets")).filter((file) => new RegExp(`^${name}-[\\w-]{8}\\.js$`).test(file));
	if (found.length !== 1) throw new Error(`dist/assets has ${found.length} scripts called ${name}.`);
	return join(dist, "assets", found[0]);
}

/** A script with every script that it imports at once, by paths below dist/. */
function withImports(script, known = new Set()) {
	if (known.has(script)) return known;
	known.add(script);
	const text = readFileSync(join(dist, script), "utf8");
	for (const [, path] of text.matchAll(/\b(?:from|import)\s*["'](\.[^"']+)["']/g))
		withImports(posix.join(dirname(script), path), known);
	return known;
}

/** Rows of the models' cores, which depend on the compiler. */
function cores() {
	return moduleNames().flatMap((name) => [
		[`${name}.wasm`, sizeOf(moduleOf(name))],
		[`${name}.wasm, gzipped`, gzipped(moduleOf(name))],
	]);
}

function app() {
	const offline = Object.keys(listFiles(dist)).map((path) => join(dist, path || "index.html"));
	const pictures = filesBelow(join(dist, "gallery")).map(sizeOf);
	return [
		["page and its scripts, gzipped", sum([...pageFiles()].map((path) => gzipped(join(dist, path))))],
		["element and its scripts, gzipped", sum([...withImports("panicle.js")].map((path) => gzipped(join(dist, path))))],
		["service worker, gzipped", gzipped(join(dist, "service-worker.js"))],
		["script of addresses of specimens, gzipped", gzipped(asset("specimens"))],
		["offline app without cores", sum(offline.filter((path) => !path.endsWith(".wasm")).map(sizeOf))],
		["number of files of the offline app", offline.length],
		["pictures of the gallery", sum(pictures)],
		["largest picture of the gallery", Math.max(...pictures)],
		["hand tracking", sum(filesBelow(join(dist, "hands")).map(sizeOf))],
	];
}

/** index.html, and the scripts and styles that it names. */
function pageFiles() {
	const html = readFileSync(join(dist, "index.html"), "utf8");
	const named = [...html.matchAll(/(?:src|href)="\.\/([^"]+\.(?:js|css))"/g)].map(([, path]) => path);
	const scripts = named.filter((path) => path.endsWith(".js")).flatMap((path) => [...withImports(path)]);
	return new Set(["index.html", ...named, ...scripts]);
}

function bakedLeaves() {
	const size = (file) => gzipped(join(leaves, file));
	const files = readdirSync(leaves).filter((file) => file.endsWith(".json"));
	const ofVines = files.filter((file) => file.startsWith("grapevine"));
	return [
		...ofVines.map((file) => [`leaf ${file.replace(".json", "")}, gzipped`, size(file)]),
		["leaves of trees, gzipped", sum(files.filter((file) => !ofVines.includes(file)).map(size))],
	];
}

/** The package, where it has been built. */
function tarball() {
	const { version } = JSON.parse(readFileSync(join(repository, "package.json"), "utf8"));
	const file = join(buildFolder, "package", `panicle-${version}.tgz`);
	return existsSync(file) ? [["package for npm", sizeOf(file)]] : [];
}

/** Identifies a build of dist/. */
export function buildId() {
	return createHash("sha256")
		.update(readFileSync(join(dist, "service-worker.js")))
		.digest("hex")
		.slice(0, 16);
}

/** Rows that browsers have measured of this build of dist/. */
function ofBrowsers() {
	if (!existsSync(measuredFolder)) return [];
	const build = buildId();
	return readdirSync(measuredFolder)
		.filter((file) => file.endsWith(".json"))
		.map((file) => JSON.parse(readFileSync(join(measuredFolder, file), "utf8")))
		.filter((each) => each.build === build)
		.map(({ row, bytes }) => [row, bytes]);
}

/** The file of a row that a browser measured. */
export const measuredFile = (row) => join(measuredFolder, `${row.replace(/[^\w]+/g, "-")}.json`);

/** The version of the compiler that makes the cores here. */
export function compilerVersion() {
	const { emscripten } = locate(["emscripten"]).found;
	return emscripten ? (emscriptenIdentity(emscripten).split(" ").at(-1) ?? "none") : "none";
}

/** Whether the app and all cores are built. */
export const isAppBuilt = () =>
	existsSync(join(dist, "service-worker.js")) && moduleNames().every((name) => existsSync(moduleOf(name)));

/**
 * Everything that is measured, by row: bytes, or a number of files.
 * @returns {Record<string, number>}
 * @throws Error where dist/ or a core is not built
 */
export function measure() {
	if (!isAppBuilt()) throw new Error("There is no built app to measure: run `npm run build`.");
	const browsers = ofBrowsers().sort(([one], [other]) => (one < other ? -1 : 1));
	return Object.fromEntries([...cores(), ...app(), ...bakedLeaves(), ...tarball(), ...browsers]);
}
