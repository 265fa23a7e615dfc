/**
 * The tools that Node alone does not bring: where they are on this machine, and how to get the missing ones. Found
 * ones are used as they are; missing ones come from the distribution's packages where that needs no question, and else
 * one message names the exact commands.
 */
import { accessSync, constants, existsSync, readFileSync, realpathSync, statSync } from "node:fs";
import { delimiter, dirname, join } from "node:path";
import { installWithApt, packageManager } from "./packages.mjs";
import { capture } from "./process.mjs";

const oldestEmscripten = "3.1.6";

/** What went wrong, in a message for the person at the terminal: no stack trace wanted. */
export class ToolchainError extends Error {}

function isProgram(path) {
	try {
		accessSync(path, constants.X_OK);
		return statSync(path).isFile();
	} catch {
		return false;
	}
}

/** The first program of these names on PATH or in one of `folders`; null if there is none. */
export function findProgram(names, env, folders = []) {
	const places = [...(env.PATH ?? "").split(delimiter).filter(Boolean), ...folders];
	const suffixes = process.platform === "win32" ? [".exe", ".bat", ".cmd"] : [""];
	for (const name of names) {
		for (const place of places) {
			const path = suffixes.map((suffix) => join(place, name + suffix)).find(isProgram);
			if (path) return path;
		}
	}
	return null;
}

/** The first folder that holds `header`. */
export function findHeader(header, env, folders) {
	const named = (env.CPATH ?? "").split(delimiter).filter(Boolean);
	return [...named, ...folders].find((folder) => existsSync(join(folder, header))) ?? null;
}

const includeFolders = ["/usr/include", "/usr/local/include", "/opt/homebrew/include", "/opt/local/include"];

/** Whether version `a`, as in 3.1.69, comes before `b`. */
export function isOlder(a, b) {
	const [x, y] = [a, b].map((version) => version.split(".").map((part) => Number.parseInt(part, 10)));
	for (let i = 0; i < Math.max(x.length, y.length); i++) {
		if ((x[i] ?? 0) !== (y[i] ?? 0)) return (x[i] ?? 0) < (y[i] ?? 0);
	}
	return false;
}

/** Emscripten keeps its version in a file beside its programs; a wrapper elsewhere has to be asked. */
function versionOfEmscripten(emcc) {
	const file = join(dirname(realpathSync(emcc)), "emscripten-version.txt");
	const text = existsSync(file) ? readFileSync(file, "utf8") : capture(emcc, ["--version"]);
	return /\d+\.\d+\.\d+/.exec(text ?? "")?.[0] ?? null;
}

/** The first emcc that is new enough: on PATH, then through EMSDK, then where distributions hide it. */
export function findEmscripten(env, hidden = ["/usr/lib/emscripten", "/usr/share/emscripten"]) {
	const sdk = env.EMSDK ? [join(env.EMSDK, "upstream/emscripten")] : [];
	const folders = [...(env.PATH ?? "").split(delimiter).filter(Boolean), ...sdk, ...hidden];
	for (const folder of folders) {
		const emcc = findProgram(["emcc"], { PATH: folder });
		const version = emcc && versionOfEmscripten(emcc);
		if (version && !isOlder(version, oldestEmscripten)) return emcc;
	}
	return null;
}

function findChromium(env) {
	if (env.CHROMIUM_PATH) return isProgram(env.CHROMIUM_PATH) ? env.CHROMIUM_PATH : null;
	const names = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];
	const applications = ["Chromium.app/Contents/MacOS/Chromium", "Google Chrome.app/Contents/MacOS/Google Chrome"];
	return findProgram(names, env) ?? applications.map((path) => join("/Applications", path)).find(isProgram) ?? null;
}

/** Each tool: what people call it, how it is found (a path or null) and which packages bring it. */
export const tools = {
	emscripten: {
		title: `Emscripten ${oldestEmscripten} or newer (emcc)`,
		find: findEmscripten,
		packages: { "apt-get": ["emscripten"], dnf: ["emscripten"], pacman: ["emscripten"], brew: ["emscripten"] },
	},
	glm: {
		title: "GLM",
		find: (env) => findHeader("glm/glm.hpp", env, [...(env.GLM_ROOT ? [env.GLM_ROOT] : []), ...includeFolders]),
		packages: { "apt-get": ["libglm-dev"], dnf: ["glm-devel"], pacman: ["glm"], brew: ["glm"] },
	},
	cmake: {
		title: "CMake",
		find: (env) => findProgram(["cmake"], env),
		packages: { "apt-get": ["cmake"], dnf: ["cmake"], pacman: ["cmake"], brew: ["cmake"] },
	},
	ninja: {
		title: "Ninja",
		find: (env) => findProgram(["ninja", "ninja-build"], env),
		packages: { "apt-get": ["ninja-build"], dnf: ["ninja-build"], pacman: ["ninja"], brew: ["ninja"] },
	},
	compiler: {
		title: "a C++ compiler",
		find: (env) => findProgram([...(env.CXX ? [env.CXX] : []), "c++", "g++", "clang++"], env),
		packages: {
			"apt-get": ["g++"],
			dnf: ["gcc-c++", "libasan", "libubsan"],
			pacman: ["gcc"],
			brew: ["llvm"],
		},
	},
	doctest: {
		title: "doctest",
		find: (env) => findHeader("doctest/doctest.h", env, includeFolders),
		packages: { "apt-get": ["doctest-dev"], dnf: ["doctest-devel"], pacman: ["doctest"], brew: ["doctest"] },
	},
	clangFormat: {
		title: "clang-format",
		find: (env) => findProgram(["clang-format"], env),
		packages: {
			"apt-get": ["clang-format"],
			dnf: ["clang-tools-extra"],
			pacman: ["clang"],
			brew: ["clang-format"],
		},
	},
	chromium: {
		title: "Chromium (or CHROMIUM_PATH naming one)",
		find: findChromium,
		packages: { "apt-get": ["chromium"], dnf: ["chromium"], pacman: ["chromium"], brew: ["--cask chromium"] },
	},
};

/** What each purpose takes. Starting the app takes nothing that only tests use. */
export const needs = {
	core: ["emscripten", "glm", "cmake", "ninja"],
	format: ["clangFormat"],
	native: ["compiler", "glm", "cmake", "ninja"],
	test: Object.keys(tools),
};

/**
 * Paths of the tools named, and the names of those that are not there.
 *
 * @param {string[]} names
 * @param {NodeJS.ProcessEnv} [env]
 * @returns {{ found: Record<string, string>, missing: string[] }}
 */
export function locate(names, env = process.env) {
	const found = {};
	const missing = [];
	for (const name of names) {
		const path = tools[name].find(env);
		if (path) found[name] = path;
		else missing.push(name);
	}
	return { found, missing };
}

function inWords(titles) {
	return titles.length < 2 ? titles.join("") : `${titles.slice(0, -1).join(", ")} and ${titles.at(-1)}`;
}

const anywhere = [
	"git clone https://github.com/emscripten-core/emsdk && cd emsdk",
	"./emsdk install latest && ./emsdk activate latest",
	"export EMSDK=$PWD",
];

/** The one message for tools that are missing and could not be had; `why` ends its first sentence. */
export function missingMessage(missing, manager, why) {
	const titles = inWords(missing.map((name) => tools[name].title));
	const packages = manager ? missing.flatMap((name) => tools[name].packages[manager.name]) : [];
	const commands = manager
		? manager.commands(packages)
		: missing.includes("emscripten")
			? anywhere
			: ["(use your system's package manager)"];
	const them = missing.length === 1 ? "it" : "them";
	return [
		`Panicle needs ${titles}, ${why}.`,
		`Install ${them} with`,
		...commands.map((command) => `  ${command}`),
		"and run the same command again.",
	].join("\n");
}

/**
 * Paths of all the tools that `purpose` takes, after installing what is missing. Throws a ToolchainError with the one
 * message where that is not possible; nothing is then left half-done.
 */
export async function prepare(purpose, { env = process.env, log = console.error } = {}) {
	const names = needs[purpose];
	const before = locate(names, env);
	if (before.missing.length === 0) return before.found;
	const manager = packageManager(env);
	const titles = before.missing.map((name) => tools[name].title);
	if (manager?.name !== "apt-get") {
		throw new ToolchainError(missingMessage(before.missing, manager, "which this machine does not have"));
	}
	log(`Installing ${inWords(titles)} …`);
	const packages = before.missing.flatMap((name) => tools[name].packages[manager.name]);
	const problem = await installWithApt(packages, env);
	const after = locate(names, env);
	if (after.missing.length === 0) return after.found;
	throw new ToolchainError(missingMessage(after.missing, manager, problem ?? "which its package did not bring"));
}

/** Environment in which this emcc runs. Debian's looks for its parsers where only Debian's own Node does. */
export function emscriptenEnvironment(emcc, env = process.env) {
	const debian = "/usr/share/nodejs";
	if (!realpathSync(emcc).startsWith("/usr/share/emscripten") || !existsSync(debian)) return { ...env };
	return { ...env, NODE_PATH: [env.NODE_PATH, debian].filter(Boolean).join(delimiter) };
}

/** What tells one toolchain from another: a build folder configured with one is of no use to the other. */
export function emscriptenIdentity(emcc) {
	return `${realpathSync(emcc)} ${versionOfEmscripten(emcc)}`;
}
