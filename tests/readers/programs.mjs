/** The programs in Python that read files (requirements.txt), installed from PyPI into build/readers. Takes Python 3.11 with its venv. */
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { run } from "../../wasm-core/tools/process.mjs";
import { buildFolder, repository } from "../../wasm-core/tools/repository.mjs";

export const folder = join(buildFolder, "readers");
export const python = join(folder, "venv/bin/python");

/** What a program says; throws where it fails. */
export async function must(command, args) {
	const { status, output } = await run(command, args, { cwd: repository });
	if (status !== 0) throw new Error(`${command} ${args.join(" ")} failed:\n${output}`);
	return output;
}

/** Installs them unless they are there. */
export async function install() {
	mkdirSync(folder, { recursive: true });
	const requirements = join(repository, "tests/readers/requirements.txt");
	const stamp = join(folder, "installed.txt");
	const wanted = readFileSync(requirements, "utf8");
	if (existsSync(stamp) && readFileSync(stamp, "utf8") === wanted) return;
	console.log("Installing the readers …");
	await must("python3.11", ["-m", "venv", join(folder, "venv")]);
	await must(python, ["-m", "pip", "install", "--quiet", "--requirement", requirements]);
	writeFileSync(stamp, wanted);
}
