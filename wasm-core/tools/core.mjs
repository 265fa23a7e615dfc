/**
 * Builds the core: `node wasm-core/tools/core.mjs` makes build/core/<model>.wasm for each model, `core.mjs asan core_tests` a native
 * target of a preset. Quick when nothing has changed. All it says goes to standard error.
 */
import { existsSync, mkdirSync, readdirSync, readFileSync, renameSync, rmSync, writeFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { withLock } from "./lock.mjs";
import { run } from "./process.mjs";
import { buildFolder, coreFolder, modelFolders, modulesFolder, testModulesFolder } from "./repository.mjs";
import { emscriptenEnvironment, emscriptenIdentity, prepare, ToolchainError } from "./toolchain.mjs";

/** The compiler's own words on what does not compile. */
export class CoreBuildError extends Error {}

const presets = ["wasm", "asan", "debug", "quick", "release"];

/** What the compiler says, less the lines that tell how far the build is and how the compiler was called. */
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

/** Configures the build folder where that has not been done with the same tools and presets. Ninja sees to the rest. */
async function configure(preset, tools, env) {
	const folder = join(buildFolder, preset);
	const compiler = tools.emscripten ? emscriptenIdentity(tools.emscripten) : tools.compiler;
	const settings = readFileSync(join(coreFolder, "CMakePresets.json"), "utf8");
	const identity = [coreFolder, tools.glm, compiler, settings].join("\n");
	const stamp = join(folder, "toolchain.txt");
	const known = existsSync(stamp) && existsSync(join(folder, "build.ninja")) ? readFileSync(stamp, "utf8") : "";
	if (known === identity) return;
	console.error(`Setting up the ${preset} build of the core …`);
	rmSync(folder, { recursive: true, force: true });
	const definitions = [`-DPANICLE_GLM_ROOT=${tools.glm}`, `-DCMAKE_MAKE_PROGRAM=${tools.ninja}`];
	if (tools.compiler) definitions.push(`-DCMAKE_CXX_COMPILER=${tools.compiler}`);
	const cmake = [tools.cmake, "--preset", preset, ...definitions];
	if (tools.emscripten) cmake.unshift(join(dirname(tools.emscripten), "emcmake"));
	await step(cmake[0], cmake.slice(1), { cwd: coreFolder, env });
	writeFileSync(stamp, identity);
}

/** Takes away modules of models that are no more: they would still be served. */
function prune(names) {
	if (!existsSync(modulesFolder)) return;
	for (const file of readdirSync(modulesFolder)) {
		if (file.endsWith(".wasm") && !names.includes(file)) rmSync(join(modulesFolder, file));
	}
}

/** Copies a module to where it is read from, whole or not at all; tells whether it is a new one. */
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
 * Builds `targets` (default: all; of wasm, the models alone) of a preset of wasm-core/CMakePresets.json. Throws a ToolchainError or a
 * CoreBuildError; modules built before then stay as they are.
 *
 * @param {string} [preset]
 * @param {string[]} [targets]
 * @returns {Promise<{ changed: boolean }>} whether a model's module is another one than before
 */
export async function buildCore(preset = "wasm", targets = []) {
	if (!presets.includes(preset)) throw new ToolchainError(`No preset ${preset}; there are ${presets.join(", ")}.`);
	const tools = await prepare(preset === "wasm" ? "core" : "native");
	const env = tools.emscripten ? emscriptenEnvironment(tools.emscripten) : process.env;
	return withLock(join(buildFolder, `${preset}.lock`), async () => {
		await configure(preset, tools, env);
		const jobs = String(availableParallelism());
		const chosen = targets.length > 0 ? targets : preset === "wasm" ? ["models"] : ["all"];
		const output = await step(
			tools.cmake,
			["--build", join(buildFolder, preset), "--parallel", jobs, "--target", ...chosen],
			{
				env,
			},
		);
		if (/warning:/.test(output)) console.error(essence(output));
		if (preset !== "wasm") return { changed: false };
		for (const name of ["core-bench.wasm", "toy.wasm"]) publish(name, testModulesFolder);
		const modules = modelFolders().map((folder) => `${folder}.wasm`);
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
