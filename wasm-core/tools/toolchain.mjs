/**
 * The tools that Node alone does not bring: where they are on this machine, and how to get the missing ones. Found
 * ones are used as they are; missing ones come from the distribution's packages where that needs no question, and else
 * one message names the exact commands.
 */
import { accessSync, constants, existsSync, readFileSync, realpathSync, statSync } from "node:fs";
import { delimiter, dirname, isAbsolute, join } from "node:path";
import { installWithApt, isOlder, packageManager } from "./packages.mjs";
import { capture } from "./process.mjs";

/** The range of Emscripten that is tested, at both ends: Debian 12 has the oldest, Debian 13 the newest. */
const oldestEmscripten = "3.1.6";
const newestEmscripten = "3.1.69";

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

/** Returns the first program of these names, or full paths, on PATH or in one of `folders`; null if there is none. */
export function findProgram(names, env, folders = []) {
	const places = [...(env.PATH ?? "").split(delimiter).filter(Boolean), ...folders];
	const suffixes = process.platform === "win32" ? [".exe", ".bat", ".cmd"] : [""];
	for (const name of names) {
		if (isAbsolute(name) && isProgram(name)) return name;
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

/** Returns Emscripten's version: from the file beside its programs, or from the output of a wrapper elsewhere. */
function versionOfEmscripten(emcc) {
	const file = join(dirname(realpathSync(emcc)), "emscripten-version.txt");
	const text = existsSync(file) ? readFileSync(file, "utf8") : capture(emcc, ["--version"]);
	return /\d+\.\d+\.\d+/.exec(text ?? "")?.[0] ?? null;
}

/** Returns the first emcc that is new enough: on PATH, then through EMSDK, then where distributions hide it. */
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

/** A Python that can make environments: Debian has what that takes in a package by itself. */
function findPython(env) {
	const python = findProgram([...(env.PYTHON ? [env.PYTHON] : []), "python3", "python"], env);
	return python && capture(python, ["-c", "import ensurepip, venv"], env) !== null ? python : null;
}

/**
 * Each tool: what people call it, how it is found (a path or null), which packages bring it, and the commands that do
 * where there is no package manager that we know.
 */
export const tools = {
	emscripten: {
		title: `Emscripten ${oldestEmscripten} or newer (emcc)`,
		find: findEmscripten,
		packages: { "apt-get": ["emscripten"], dnf: ["emscripten"], pacman: ["emscripten"], brew: ["emscripten"] },
		elsewhere: [
			"git clone https://github.com/emscripten-core/emsdk",
			`emsdk/emsdk install ${newestEmscripten} && emsdk/emsdk activate ${newestEmscripten}`,
			"export EMSDK=$PWD/emsdk",
		],
	},
	glm: {
		title: "GLM",
		find: (env) => findHeader("glm/glm.hpp", env, [...(env.GLM_ROOT ? [env.GLM_ROOT] : []), ...includeFolders]),
		packages: { "apt-get": ["libglm-dev"], dnf: ["glm-devel"], pacman: ["glm"], brew: ["glm"] },
		elsewhere: ["git clone --branch 1.0.1 https://github.com/g-truc/glm", "export GLM_ROOT=$PWD/glm"],
	},
	cmake: {
		title: "CMake",
		find: (env) => findProgram(["cmake"], env),
		packages: { "apt-get": ["cmake"], dnf: ["cmake"], pacman: ["cmake"], brew: ["cmake"] },
		elsewhere: ["python3 -m pip install cmake"],
	},
	ninja: {
		title: "Ninja",
		find: (env) => findProgram(["ninja", "ninja-build"], env),
		packages: { "apt-get": ["ninja-build"], dnf: ["ninja-build"], pacman: ["ninja"], brew: ["ninja"] },
		elsewhere: ["python3 -m pip install ninja"],
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
		elsewhere: ["export CXX=/path/to/a/C++20/compiler"],
	},
	ccache: {
		title: "ccache",
		find: (env) => findProgram(["ccache"], env),
		packages: { "apt-get": ["ccache"], dnf: ["ccache"], pacman: ["ccache"], brew: ["ccache"] },
		elsewhere: [],
	},
	"clang-tidy": {
		title: "clang-tidy",
		find: (env) => findProgram(["clang-tidy", "/opt/homebrew/opt/llvm/bin/clang-tidy"], env),
		packages: { "apt-get": ["clang-tidy"], dnf: ["clang-tools-extra"], pacman: ["clang"], brew: ["llvm"] },
		elsewhere: ["python3 -m pip install clang-tidy"],
	},
	doctest: {
		title: "doctest",
		find: (env) => findHeader("doctest/doctest.h", env, includeFolders),
		packages: { "apt-get": ["doctest-dev"], dnf: ["doctest-devel"], pacman: ["doctest"], brew: ["doctest"] },
		elsewhere: ["git clone https://github.com/doctest/doctest", "export CPATH=$PWD/doctest"],
	},
	python: {
		title: "Python 3 with its venv",
		find: findPython,
		packages: { "apt-get": ["python3-venv"], dnf: ["python3"], pacman: ["python"], brew: ["python"] },
		elsewhere: ["export PYTHON=/path/to/python3"],
	},
	chromium: {
		title: "Chromium",
		find: findChromium,
		packages: { "apt-get": ["chromium"], dnf: ["chromium"], pacman: ["chromium"], brew: ["--cask chromium"] },
		elsewhere: [
			"npx playwright install --with-deps chromium",
			"export CHROMIUM_PATH=$(node -p 'require(\"@playwright/test\").chromium.executablePath()')",
		],
	},
};

/** What each purpose needs. Starting the app needs nothing that only tests use. */
export const needs = {
	core: ["emscripten", "glm", "cmake", "ninja"],
	format: [],
	lint: ["clang-tidy", "compiler", "glm", "cmake", "ninja"],
	native: ["compiler", "glm", "cmake", "ninja"],
	trimesh: ["python"],
	test: Object.keys(tools).filter((name) => !["ccache", "clang-tidy"].includes(name)),
};

/** Optional tools by purpose: used if present, and installed together with required ones that are missing. */
const optionalTools = { core: ["ccache"], native: ["ccache"], test: ["ccache"] };

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

/**
 * Returns the message about all tools that are missing and could not be installed; `why` ends its first sentence. Tools
 * whose packages are `unfit` come from elsewhere.
 */
export function missingMessage(missing, manager, why, unfit = []) {
	const packagesOf = (name) => (manager ? tools[name].packages[manager.name] : []);
	const fromPackages = missing.filter((name) => manager && !packagesOf(name).some((p) => unfit.includes(p)));
	const elsewhere = missing.filter((name) => !fromPackages.includes(name));
	const commands = [
		...(fromPackages.length > 0 ? manager.commands(fromPackages.flatMap(packagesOf)) : []),
		...elsewhere.flatMap((name) => tools[name].elsewhere),
	];
	return [
		`Panicle needs ${inWords(missing.map((name) => tools[name].title))}, ${why}.`,
		`Install ${missing.length === 1 ? "it" : "them"} with`,
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
	const optional = locate(optionalTools[purpose] ?? [], env);
	const { found, missing } = locate(names, env);
	if (missing.length === 0) return { ...found, ...optional.found };
	const manager = packageManager(env);
	if (manager?.name !== "apt-get") {
		throw new ToolchainError(missingMessage(missing, manager, "which this machine does not have"));
	}
	log(`Installing ${inWords(missing.map((name) => tools[name].title))} …`);
	const packages = [...missing, ...optional.missing].flatMap((name) => tools[name].packages[manager.name]);
	const problem = await installWithApt(packages, { emscripten: oldestEmscripten }, env);
	const after = locate(names, env);
	if (after.missing.length === 0) return { ...after.found, ...locate(optionalTools[purpose] ?? [], env).found };
	const { why, unfit } = problem ?? {
		why: "which its package did not bring",
		unfit: after.missing.flatMap((name) => tools[name].packages[manager.name]),
	};
	throw new ToolchainError(missingMessage(after.missing, manager, why, unfit));
}

/** Environment in which this emcc runs. Debian's looks for its parsers where only Debian's own Node does. */
export function emscriptenEnvironment(emcc, env = process.env) {
	const debian = "/usr/share/nodejs";
	if (!realpathSync(emcc).startsWith("/usr/share/emscripten") || !existsSync(debian)) return { ...env };
	return { ...env, NODE_PATH: [env.NODE_PATH, debian].filter(Boolean).join(delimiter) };
}

/**
 * The clang++ that em++ would start, with the flags that it would add to every source; null if Emscripten does not print it.
 *
 * @param {string} emcc
 * @param {NodeJS.ProcessEnv} env
 * @returns {string[] | null}
 */
export function findEmscriptenClang(emcc, env) {
	const folder = dirname(emcc);
	const setting = (name) => capture(join(folder, "em-config"), [name], env)?.trim();
	// Debian's clang has its version in its name.
	const version = setting("CLANG_ADD_VERSION");
	const clang = findProgram([version ? `clang++-${version}` : "clang++"], { PATH: setting("LLVM_ROOT") });
	const flags = capture(join(folder, "em++"), ["--cflags"], env)?.trim();
	return clang && flags ? [clang, ...flags.split(/\s+/)] : null;
}

/**
 * A warning about an Emscripten newer than those that are tested; undefined for one in the range. An older one is not found
 * in the first place.
 *
 * @param {string} emcc
 */
export function emscriptenWarning(emcc) {
	const version = versionOfEmscripten(emcc) ?? "";
	if (!isOlder(newestEmscripten, version)) return undefined;
	return `Emscripten ${version} is newer than those tested (${oldestEmscripten} to ${newestEmscripten}): sizes and speed may differ.`;
}

/** Returns an identifier of a toolchain: a build folder that was configured with another one cannot be used. */
export function emscriptenIdentity(emcc) {
	return `${realpathSync(emcc)} ${versionOfEmscripten(emcc)}`;
}
