/**
 * `npm run lint`: checks code without changing it: the format of all files, Biome's rules (TypeScript, JavaScript, CSS,
 * HTML), and clang-tidy's (C++, wasm-core/.clang-tidy) on the files that this branch has changed. `-- --all` runs
 * clang-tidy on all files of the core. `-- --gate`, for `npm test`: clang-tidy only where it is installed, and on a few
 * changed files at most.
 */
import { readFileSync } from "node:fs";
import { availableParallelism } from "node:os";
import { join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { changedFiles } from "./changes.mjs";
import { checkFormat } from "./format.mjs";
import { filesIn } from "./fresh.mjs";
import { run } from "./process.mjs";
import { buildFolder, coreFolder, repository } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";
import { locate, needs, prepare, ToolchainError } from "./toolchain.mjs";

/** Files that `--gate` has clang-tidy check at most: each takes about 3 seconds of a processor. */
const GATE_FILES = 6;

const isOfCore = (path) => /^wasm-core\/.*\.(cpp|hpp|h)$/.test(path);

/**
 * Returns the translation units of the core as the native build compiles them, by their paths from the root of the repository.
 * Configures a build folder of its own, which nothing is built in.
 *
 * @param {Record<string, string>} tools
 */
async function compiledFiles(tools, folder) {
	const definitions = [
		"-DCMAKE_BUILD_TYPE=Debug",
		`-DPANICLE_GLM_ROOT=${tools.glm}`,
		`-DCMAKE_MAKE_PROGRAM=${tools.ninja}`,
		`-DCMAKE_CXX_COMPILER=${tools.compiler}`,
	];
	const { status, output } = await run(tools.cmake, ["-S", coreFolder, "-B", folder, "-G", "Ninja", ...definitions]);
	if (status !== 0) throw new ToolchainError(`The core cannot be configured:\n${output}`);
	const commands = JSON.parse(readFileSync(join(folder, "compile_commands.json"), "utf8"));
	return [...new Set(commands.map(({ file }) => relative(repository, file).replaceAll("\\", "/")))]
		.filter(isOfCore)
		.sort();
}

/**
 * Lists the translation units whose check covers the changed files: a source covers itself, a header is covered by the
 * source of the same name, or else by the first one that includes it.
 */
export function unitsOf(changed, units, read = (path) => readFileSync(join(repository, path), "utf8")) {
	const coveredBy = (path) => {
		if (path.endsWith(".cpp")) return units.includes(path) ? path : undefined;
		const source = path.replace(/\.(hpp|h)$/, ".cpp");
		if (units.includes(source)) return source;
		const include = `"${path.replace(/^wasm-core\/(src\/)?/, "")}"`;
		return units.find((unit) => read(unit).includes(include));
	};
	return [...new Set(changed.filter(isOfCore).map(coveredBy))].filter((unit) => unit !== undefined).sort();
}

/** Runs clang-tidy on the units; returns its findings. */
async function tidy(program, folder, units) {
	const waiting = [...units];
	const findings = [];
	const work = async () => {
		for (let unit = waiting.shift(); unit; unit = waiting.shift()) {
			const { status, output } = await run(program, ["-p", folder, "--quiet", join(repository, unit)]);
			// Counts of warnings in system headers are no findings.
			if (status !== 0) findings.push(output.replace(/^\d+ warnings? .*generated\.\n/gm, "").trim());
		}
	};
	await Promise.all(Array.from({ length: availableParallelism() }, work));
	return findings;
}

/**
 * Runs clang-tidy on the changed files, or on all; returns its findings.
 * @param {{ all: boolean, gate: boolean }} options
 */
async function checkCplusplus({ all, gate }) {
	const changed = all
		? filesIn("wasm-core").map((file) => relative(repository, file).replaceAll("\\", "/"))
		: changedFiles();
	if (!changed) {
		console.error("clang-tidy: no git history to tell what has changed; `npm run lint -- --all` checks all files");
		return [];
	}
	if (!changed.some(isOfCore)) return [];
	if (gate && locate(needs.lint).missing.length > 0) {
		console.error("clang-tidy is not installed, so that C++ is not checked; `npm run lint` installs it");
		return [];
	}
	const tools = await prepare("lint");
	const folder = join(buildFolder, "lint");
	const units = unitsOf(changed, await compiledFiles(tools, folder));
	const chosen = gate ? units.slice(0, GATE_FILES) : units;
	const rest = units.length > chosen.length ? ` of ${units.length}; \`npm run lint\` checks all of them` : "";
	console.error(`clang-tidy checks ${chosen.length} ${chosen.length === 1 ? "file" : "files"}${rest}`);
	return tidy(tools["clang-tidy"], folder, chosen);
}

if (process.argv[1] === fileURLToPath(import.meta.url))
	await command(async () => {
		await setUp("format");
		const options = { all: process.argv.includes("--all"), gate: process.argv.includes("--gate") };
		const problems = await checkFormat();
		for (const problem of problems) console.error(problem);
		const findings = await checkCplusplus(options);
		for (const finding of findings) console.error(finding);
		if (problems.length + findings.length > 0) throw new ToolchainError("Lint failed: see above.");
	});
