/** `npm run format`: lays out every file as `npm test` wants it. With `--check` it writes nothing and fails where it would. */
import { readdirSync } from "node:fs";
import { join } from "node:path";
import { run } from "./process.mjs";
import { repository } from "./repository.mjs";
import { command, setUp } from "./setup.mjs";
import { ToolchainError } from "./toolchain.mjs";

const folders = ["wasm-core/src", "wasm-core/bench", "wasm-core/tools", "tests/core"];

function cplusplusFiles() {
	const inFolder = (folder) => {
		try {
			return readdirSync(join(repository, folder), { recursive: true }).map((name) => join(folder, name));
		} catch {
			return [];
		}
	};
	return folders
		.flatMap(inFolder)
		.filter((name) => /\.(cpp|hpp|h)$/.test(name))
		.sort();
}

await command(async () => {
	const check = process.argv.includes("--check");
	const { clangFormat } = await setUp("format");
	const style = `--style=file:${join(repository, "wasm-core/.clang-format")}`;
	const mode = check ? ["--dry-run", "--Werror"] : ["-i"];
	const cplusplus = await run(clangFormat, [style, ...mode, ...cplusplusFiles()], {
		cwd: repository,
		show: process.stderr,
	});
	const biome = join(repository, "node_modules/@biomejs/biome/bin/biome");
	const biomeArgs = check ? ["ci"] : ["check", "--write"];
	const web = await run(process.execPath, [biome, ...biomeArgs], { cwd: repository, show: process.stderr });
	if (cplusplus.status !== 0 || web.status !== 0) {
		throw new ToolchainError(
			check ? "Not laid out or not clean: run `npm run format`." : "Some problems need a person.",
		);
	}
});
