/**
 * `npm run format`: formats all files and applies the safe fixes of Biome. `npm run lint` only checks. Both formatters
 * are npm packages of a fixed version: those of distributions differ from each other.
 */
import { existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { run } from "./process.mjs";
import { coreFolder, repository } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";
import { ToolchainError } from "./toolchain.mjs";

const folders = ["wasm-core/src", "wasm-core/bench", "wasm-core/tools", "tests/core", "tests/toy"];

/** Lists the C++ files, without generated ones, which git ignores. */
function cplusplusFiles() {
	const inFolder = (folder) => readdirSync(folder, { recursive: true }).map((name) => join(folder, name));
	return folders
		.map((folder) => join(repository, folder))
		.filter(existsSync)
		.flatMap(inFolder)
		.filter((name) => /\.(cpp|hpp|h)$/.test(name) && !name.endsWith(".generated.hpp"))
		.sort();
}

/** Formats the C++ files; returns those that were not formatted, from the root of the repository. */
export async function formatCplusplus({ write }) {
	const { format } = await import("@wasm-fmt/clang-format/node");
	const style = readFileSync(join(coreFolder, ".clang-format"), "utf8");
	const changed = cplusplusFiles().filter((file) => {
		const text = readFileSync(file, "utf8");
		const formatted = format(text, file, style);
		if (formatted === text) return false;
		if (write) writeFileSync(file, formatted);
		return true;
	});
	return changed.map((file) => relative(repository, file));
}

/** Formats and lints TypeScript, JavaScript, CSS and HTML; whether they are clean. */
export async function biome({ write }) {
	const program = join(repository, "node_modules/@biomejs/biome/bin/biome");
	const args = [
		program,
		...(write ? ["check", "--write"] : ["ci"]),
		"--error-on-warnings",
		`--colors=${process.stderr.isTTY ? "force" : "off"}`,
	];
	return (await run(process.execPath, args, { cwd: repository, show: process.stderr })).status === 0;
}

/** Checks the format of all files and the rules of Biome without changing anything; returns one line per problem. */
export async function checkFormat() {
	const problems = (await formatCplusplus({ write: false })).map((file) => `${file}: not formatted`);
	if (!(await biome({ write: false }))) problems.push("Biome: see above");
	return problems.length > 0
		? [...problems, "`npm run format` formats, and fixes what can be fixed without a decision."]
		: [];
}

if (process.argv[1] === fileURLToPath(import.meta.url))
	await command(async () => {
		await setUp("format");
		for (const file of await formatCplusplus({ write: true })) console.error(`${file}: formatted`);
		if (!(await biome({ write: true }))) throw new ToolchainError("Fix the rest by hand: see above.");
	});
