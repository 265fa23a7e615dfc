/**
 * Browsers besides Chromium: where they are on this machine, and how Debian's packages bring them. The tests do with those
 * that can be had. Runs on a clean clone: nothing here may import a package.
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

/** Mesa, by which WebGL 2 is drawn without a graphics card; `MESA` names its folder where that is no usual one. */
const findMesa = ({ MESA }) =>
	(MESA ? [MESA] : libraries).map((folder) => join(folder, "libEGL_mesa.so.0")).find(existsSync) ?? null;

const parts = {
	firefox: { find: (env) => findProgram(["firefox-esr", "firefox"], env), packages: ["firefox-esr"] },
	webkit: { find: (env) => findProgram(["WebKitWebDriver"], env), packages: ["webkit2gtk-driver"] },
	screen: { find: (env) => findProgram(["Xvfb"], env), packages: ["xvfb"] },
	mesa: { find: findMesa, packages: ["libegl1", "libgl1-mesa-dri"] },
};

/** What each takes. Neither shows WebGL 2 without a screen. */
export const browsers = {
	firefox: { title: "Firefox", parts: ["firefox", "screen", "mesa"] },
	webkit: { title: "WebKit", parts: ["webkit", "screen", "mesa"] },
};

const missingOf = (name, env) => browsers[name].parts.filter((part) => !parts[part].find(env));

/**
 * The program that a browser is driven by.
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
 * Browsers that can be had, after installing what is missing, each by itself; and why others cannot, a line for each.
 *
 * @param {{ env?: NodeJS.ProcessEnv, install?: typeof installWithApt, log?: (line: string) => void }} [by]
 * @returns {Promise<{ there: string[], without: string[] }>}
 */
export async function prepareBrowsers({ env = process.env, install = installWithApt, log = console.error } = {}) {
	const there = [];
	const without = [];
	for (const [name, { title }] of Object.entries(browsers)) {
		const why = await whyNot(name, env, install, log);
		if (why) without.push(`${title} is not tested: ${why}.`);
		else there.push(name);
	}
	return { there, without };
}

/** Why a browser cannot be had; null when it is there. */
async function whyNot(name, env, install, log) {
	const missing = missingOf(name, env);
	if (missing.length === 0) return null;
	const packages = missing.flatMap((part) => parts[part].packages);
	if (packageManager(env)?.name !== "apt-get") return `this machine lacks ${packages.join(", ")}`;
	log(`Installing ${packages.join(", ")} …`);
	const problem = await install(packages, {}, env);
	if (missingOf(name, env).length === 0) return null;
	return problem ? `it is not there ${problem.why}` : `${packages.join(", ")} did not bring it`;
}
