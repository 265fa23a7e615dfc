/**
 * Browsers besides Chromium: where they are on this machine, and which Debian packages install them. The tests use the browsers
 * that are available. Runs on a clean clone: nothing here may import a package.
 */
import { existsSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { installWithApt, packageManager } from "../../wasm-core/tools/packages.mjs";
import { findProgram } from "../../wasm-core/tools/toolchain.mjs";

const libraries = ["/usr/lib64", "/usr/lib"].flatMap((folder) => [
	folder,
	...(existsSync(folder) ? readdirSync(folder).filter((name) => name.endsWith("-linux-gnu")) : []).map((name) =>
		join(folder, name),
	),
]);

/** Mesa, which draws WebGL 2 without a graphics card. `MESA` names its folder if it is not a usual one. */
const findMesa = ({ MESA }) =>
	(MESA ? [MESA] : libraries).map((folder) => join(folder, "libEGL_mesa.so.0")).find(existsSync) ?? null;

const parts = {
	firefox: { find: (env) => findProgram(["firefox-esr", "firefox"], env), packages: ["firefox-esr"] },
	webkit: { find: (env) => findProgram(["WebKitWebDriver"], env), packages: ["webkit2gtk-driver"] },
	screen: { find: (env) => findProgram(["Xvfb"], env), packages: ["xvfb"] },
	mesa: { find: findMesa, packages: ["libegl1", "libgl1-mesa-dri"] },
};

/** The parts that each browser needs. Neither shows WebGL 2 without a screen. */
export const browsers = {
	firefox: { title: "Firefox", parts: ["firefox", "screen", "mesa"] },
	webkit: { title: "WebKit", parts: ["webkit", "screen", "mesa"] },
};

const missingOf = (name, env) => browsers[name].parts.filter((part) => !parts[part].find(env));
const packagesOf = (missing) => missing.flatMap((part) => parts[part].packages);

/**
 * The packages that the browsers on this machine still lack.
 *
 * @returns {string[]}
 */
export function missingPackages(env = process.env) {
	return packagesOf([...new Set(Object.keys(browsers).flatMap((name) => missingOf(name, env)))]);
}

/**
 * The program that drives a browser.
 *
 * @param {string} name
 * @throws when it is not on this machine
 */
export function find(name, env = process.env) {
	const path = parts[name].find(env);
	if (!path)
		throw new Error(
			`${browsers[name].title} is not on this machine; \`npm test -- browsers\` installs it where it can.`,
		);
	return path;
}

/**
 * Installs the missing packages of all browsers in one call, and if that fails, of each browser by itself.
 *
 * @returns the browsers that are available, and a line for each of the others with the reason.
 * @param {{ env?: NodeJS.ProcessEnv, install?: typeof installWithApt, log?: (line: string) => void }} [by]
 * @returns {Promise<{ there: string[], without: string[] }>}
 */
export async function prepareBrowsers({ env = process.env, install = installWithApt, log = console.error } = {}) {
	const there = [];
	const without = [];
	const missing = missingPackages(env);
	if (missing.length > 0 && packageManager(env)?.name === "apt-get") {
		log(`Installing ${missing.join(", ")} …`);
		await install(missing, {}, env);
	}
	for (const [name, { title }] of Object.entries(browsers)) {
		const why = await whyNot(name, env, install, log);
		if (why) without.push(`${title} is not tested: ${why}.`);
		else there.push(name);
	}
	return { there, without };
}

/** Why a browser is not available, after a try to install it; null when it is. */
async function whyNot(name, env, install, log) {
	const missing = missingOf(name, env);
	if (missing.length === 0) return null;
	const packages = packagesOf(missing);
	if (packageManager(env)?.name !== "apt-get") return `this machine lacks ${packages.join(", ")}`;
	log(`Installing ${packages.join(", ")} …`);
	const problem = await install(packages, {}, env);
	if (missingOf(name, env).length === 0) return null;
	return problem ? `it is not there ${problem.why}` : `${packages.join(", ")} did not bring it`;
}
