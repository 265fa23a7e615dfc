/**
 * Builds the core: `node wasm-core/tools/core.mjs` makes build/core/<model>.wasm for each model, `core.mjs asan
 * core_tests` a native target of a preset. Quick when nothing has changed. Messages go to standard error.
 */
import { existsSync, mkdirSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { generateCode } from "./generate/files.mjs";
import { withLock } from "./lock.mjs";
import { run } from "./process.mjs";
import { buildFolder, coreFolder, moduleNames, modulesFolder, repository, testModulesFolder } from "./repository.mjs";
import {
	emscriptenEnvironment,
	emscriptenIdentity,
	emscriptenWarning,
	findEmscriptenClang,
	prepare,
	ToolchainError,
} from "./toolchain.mjs";

/** The core does not compile; the message is the compiler's. */
export class CoreBuildError extends Error {}

const presets = ["wasm", "native", "asan", "debug", "release"];

/**
 * Settings by which one compiler cache (ccache) serves every checkout on this machine: paths below the repository are
 * hashed relative to it, and the folder in which the compiler runs is left out.
 */
const cacheEnvironment = { CCACHE_BASEDIR: repository, CCACHE_NOHASHDIR: "1" };

/** Returns the compiler's messages, without the lines about progress and about the compiler's own command. */
function essence(output) {
	const lines = output.split("\n");
	const noise = /^\[\d+\/\d+\] |^ninja: |^-- |^configure: |^em\+\+: error: '.*failed \(returned/;
	const said = lines.filter((line, i) => !noise.test(line) && !lines[i - 1]?.startsWith("FAILED: "));
	return said.join("\n").trim() || output.trim();
}

async function step(command, args, options) {
	const { status, output } = await run(command, args, options);
	if (status !== 0) throw new CoreBuildError(essence(output));
	return output;
}

/**
 * Configures a build folder unless that was done with the same tools and presets; Ninja does the rest. Rooms to
 * sanitize are a setting that changes from run to run: only what they change is compiled again.
 */
async function configure(preset, tools, env, sanitizeRooms) {
	const folder = join(buildFolder, preset);
	const compiler = tools.emscripten ? emscriptenIdentity(tools.emscripten) : tools.compiler;
	const settings = readFileSync(join(coreFolder, "CMakePresets.json"), "utf8");
	// A folder that was configured with anything else is deleted; other rooms only change a definition.
	const identity = [coreFolder, tools.glm, compiler, tools.ccache, settings].join("\n");
	const stamp = join(folder, "toolchain.txt");
	const roomsStamp = join(folder, "sanitized_rooms.txt");
	const read = (file) => (existsSync(file) ? readFileSync(file, "utf8") : "");
	const isSame = existsSync(join(folder, "build.ninja")) && read(stamp) === identity;
	const rooms = sanitizeRooms?.join(";") ?? read(roomsStamp);
	if (isSame && rooms === read(roomsStamp)) return;
	if (!isSame) {
		console.error(`Setting up the ${preset} build of the core …`);
		rmSync(folder, { recursive: true, force: true });
		const warning = tools.emscripten && emscriptenWarning(tools.emscripten);
		if (warning) console.error(warning);
	}
	const definitions = [
		`-DPANICLE_GLM_ROOT=${tools.glm}`,
		`-DCMAKE_MAKE_PROGRAM=${tools.ninja}`,
		`-DPANICLE_SANITIZE_ROOMS=${rooms}`,
		`-DPANICLE_CCACHE=${tools.ccache ?? ""}`,
	];
	if (tools.compiler) definitions.push(`-DCMAKE_CXX_COMPILER=${tools.compiler}`);
	const clang = tools.emscripten && findEmscriptenClang(tools.emscripten, env);
	if (clang) definitions.push(`-DPANICLE_CLANG=${clang.join(";")}`);
	const cmake = [tools.cmake, "--preset", preset, ...definitions];
	if (tools.emscripten) cmake.unshift(join(dirname(tools.emscripten), "emcmake"));
	await step(cmake[0], cmake.slice(1), { cwd: coreFolder, env });
	writeFileSync(stamp, identity);
	writeFileSync(roomsStamp, rooms);
}

/** Removes modules of models that no longer exist: they would still be served. */
function prune(names) {
	if (!existsSync(modulesFolder)) return;
	for (const file of readdirSync(modulesFolder)) {
		if (file.endsWith(".wasm") && !names.includes(file)) rmSync(join(modulesFolder, file));
	}
}

/** Copies a module into the folder of finished modules, atomically; returns whether it differs from the last one. */
function publish(name, folder = modulesFolder) {
	const from = join(buildFolder, "wasm", name);
	const to = join(folder, name);
	if (!existsSync(from)) return false;
	const bytes = readFileSync(from);
	if (existsSync(to) && bytes.equals(readFileSync(to))) return false;
	mkdirSync(folder, { recursive: true });
	const partial = `${to}.${process.pid}`;
	writeFileSync(partial, bytes);
	renameSync(partial, to);
	return true;
}

/**
 * Builds `targets` of a preset of wasm-core/CMakePresets.json. Throws a ToolchainError or a CoreBuildError; modules built
 * before then stay as they are. `PANICLE_CORE=built` means that the modules have just been built: programs that another
 * program has started then do not check them again.
 *
 * @param {string} [preset]
 * @param {string[]} [targets] default: everything; of preset wasm, the modules of all models
 * @param {{ sanitizeRooms?: string[] }} [options] sanitizeRooms: of preset native, the rooms to build with sanitizers;
 *   default: those of the last build
 * @returns {Promise<{ changed: boolean }>} whether a model's module is not the one from before
 */
export async function buildCore(preset = "wasm", targets = [], { sanitizeRooms } = {}) {
	generateCode();
	if (preset === "wasm" && process.env.PANICLE_CORE === "built") return { changed: false };
	if (!presets.includes(preset)) throw new ToolchainError(`No preset ${preset}; there are ${presets.join(", ")}.`);
	const tools = await prepare(preset === "wasm" ? "core" : "native");
	const env = { ...(tools.emscripten ? emscriptenEnvironment(tools.emscripten) : process.env), ...cacheEnvironment };
	return withLock(join(buildFolder, `${preset}.lock`), async () => {
		await configure(preset, tools, env, sanitizeRooms);
		const jobs = String(availableParallelism());
		const chosen = targets.length > 0 ? targets : preset === "wasm" ? ["models"] : ["all"];
		const build = ["--build", join(buildFolder, preset), "--parallel", jobs, "--target", ...chosen];
		const output = await step(tools.cmake, build, { env });
		if (/warning:/.test(output)) console.error(essence(output));
		if (preset !== "wasm") return { changed: false };
		for (const name of ["core-bench.wasm", "toy.wasm"]) publish(name, testModulesFolder);
		const modules = moduleNames().map((name) => `${name}.wasm`);
		prune(modules);
		return { changed: modules.filter((name) => publish(name)).length > 0 };
	});
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
	try {
		await buildCore(process.argv[2], process.argv.slice(3));
	} catch (error) {
		if (!(error instanceof ToolchainError || error instanceof CoreBuildError)) throw error;
		console.error(error.message);
		process.exitCode = 1;
	}
}
