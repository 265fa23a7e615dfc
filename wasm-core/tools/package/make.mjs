/** Makes the npm package: scripts, cores, types, manifest and documents, packed into one tarball. */
import { copyFileSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { buildCore } from "../core.mjs";
import { filesIn, isFresh, remember } from "../fresh.mjs";
import { withLock } from "../lock.mjs";
import { npm } from "../npm_packages.mjs";
import { buildFolder, moduleNames, moduleOf, repository } from "../repository.mjs";
import { ToolchainError } from "../toolchain.mjs";
import { bundlePackage } from "./bundle.mjs";
import { pagesOf } from "./pages.mjs";
import { writeTypes } from "./types.mjs";

const place = join(buildFolder, "package");
/** The folder that npm packs. */
export const packageFolder = join(place, "panicle");
const stamp = join(place, "made_from.txt");
const pages = join(place, "pages.json");
const docs = ["LICENSE", "CHANGELOG.md", "docs/package.md"];

/** Returns the manifest of the published package; the repository's package.json describes the workspace. */
export function manifest() {
	const { name, version, license, engines, devDependencies } = JSON.parse(
		readFileSync(join(repository, "package.json"), "utf8"),
	);
	const door = (file, more = {}) => ({ types: `./${file}.d.ts`, ...more, default: `./${file}.js` });
	return {
		name,
		version,
		description:
			"Grape bunches, leaves, trees and roots grown from botanical models: a library, and an element for any page",
		keywords: ["procedural", "modeling", "plant", "grape", "l-system", "gltf", "three", "webassembly"],
		license,
		type: "module",
		engines,
		exports: {
			".": {
				types: "./panicle.d.ts",
				node: "./node.js",
				worker: "./browser.js",
				browser: "./browser.js",
				default: "./browser.js",
			},
			"./three": door("three"),
			"./forest": door("forest"),
			"./element": door("element"),
			"./cores/*": "./cores/*",
			"./package.json": "./package.json",
		},
		types: "./panicle.d.ts",
		// Loading one of these has an effect: it sets where plants are grown, or defines the element.
		sideEffects: ["./node.js", "./browser.js", "./element.js"],
		peerDependencies: { three: `>=${devDependencies["@types/three"].replace("^", "")}` },
		peerDependenciesMeta: { three: { optional: true } },
	};
}

/**
 * Makes the package unless it is up to date with its sources.
 * @returns {Promise<{ tarball: string, pages: Record<string, string> }>} the pages of docs/api as texts, by their names
 */
export async function makePackage() {
	await buildCore();
	return withLock(join(buildFolder, "package.lock"), async () => {
		const { name, version } = manifest();
		const tarball = join(place, `${name}-${version}.tgz`);
		const inputs = [
			...filesIn("web/src", "wasm-core/tools/package", "package.json", "package-lock.json", "tsconfig.json", ...docs),
			...moduleNames().map(moduleOf),
		];
		if (!isFresh(tarball, stamp, inputs)) {
			await write(tarball);
			remember(stamp, inputs);
		}
		return { tarball, pages: JSON.parse(readFileSync(pages, "utf8")) };
	});
}

/** Builds the package's folder and packs it by npm into the tarball. */
async function write(tarball) {
	rmSync(place, { recursive: true, force: true });
	mkdirSync(packageFolder, { recursive: true });
	const licences = await bundlePackage(packageFolder);
	writeFileSync(pages, JSON.stringify(pagesOf(await writeTypes(packageFolder))));
	writeFileSync(join(packageFolder, "package.json"), `${JSON.stringify(manifest(), null, "\t")}\n`);
	writeFileSync(join(packageFolder, "THIRD-PARTY.txt"), licences);
	writeFileSync(join(packageFolder, "README.md"), readme());
	for (const file of ["LICENSE", "CHANGELOG.md"]) copyFileSync(join(repository, file), join(packageFolder, file));
	const { status, output } = await npm(["pack", "--silent", "--pack-destination", place], packageFolder);
	if (status !== 0 || !existsSync(tarball)) throw new ToolchainError(`npm pack failed:\n${output.trim()}`);
}

/** Returns docs/package.md without links to other pages, which the package does not contain. */
function readme() {
	const text = readFileSync(join(repository, "docs/package.md"), "utf8");
	return text.replace(/\[([^\]]+)\]\((?![a-z]+:)[^)]*\)/g, "$1");
}
