/**
 * `npm run format`: lays out every file as `npm test` wants it. With `--check` it writes nothing and fails where it would.
 * Both formatters are npm packages of a fixed version: those of distributions differ from each other.
 */
import { existsSync, readdirSync, readFileSync, writeFileSync } from "node:fs";
import { join, relative } from "node:path";
import { run } from "./process.mjs";
import { coreFolder, repository } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";
import { ToolchainError } from "./toolchain.mjs";

const folders = ["wasm-core/src", "wasm-core/bench", "wasm-core/tools", "tests/core"];

/** C++ files but for generated ones, which their makers format and git ignores. */
function cplusplusFiles() {
	const inFolder = (folder) => readdirSync(folder, { recursive: true }).map((name) => join(folder, name));
	return folders
		.map((folder) => join(repository, folder))
		.filter(existsSync)
		.flatMap(inFolder)
		.filter((name) => /\.(cpp|hpp|h)$/.test(name) && !name.endsWith(".generated.hpp"))
		.sort();
}

/** Lays out the C++ files; returns those that were not. */
async function formatCplusplus(write) {
	const { format } = await import("@wasm-fmt/clang-format/node");
	const style = readFileSync(join(coreFolder, ".clang-format"), "utf8");
	return cplusplusFiles().filter((file) => {
		const text = readFileSync(file, "utf8");
		const laidOut = format(text, file, style);
		if (laidOut === text) return false;
		if (write) writeFileSync(file, laidOut);
		return true;
	});
}

/** Formats and lints everything else. */
async function biome(write) {
	const program = join(repository, "node_modules/@biomejs/biome/bin/biome");
	const args = [
		program,
		...(write ? ["check", "--write"] : ["ci"]),
		"--error-on-warnings",
		`--colors=${process.stderr.isTTY ? "force" : "off"}`,
	];
	return (await run(process.execPath, args, { cwd: repository, show: process.stderr })).status === 0;
}

await command(async () => {
	const write = !process.argv.includes("--check");
	await setUp("format");
	const strayed = await formatCplusplus(write);
	for (const file of strayed)
		console.error(`${relative(repository, file)}: ${write ? "laid out" : "not as clang-format lays it out"}`);
	const clean = await biome(write);
	if (!write && strayed.length > 0) throw new ToolchainError("Not laid out: run `npm run format`.");
	if (!clean) throw new ToolchainError(write ? "The rest needs a person." : "Not clean: run `npm run format`.");
});
