/** Programs in Python that read files, installed from PyPI into build/ once: each list of them in an environment of its own. */
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { run } from "../../wasm-core/tools/process.mjs";
import { buildFolder, repository } from "../../wasm-core/tools/repository.mjs";

/** Output of a program; throws where it fails. */
export async function must(command, args) {
	const { status, output } = await run(command, args, { cwd: repository });
	if (status !== 0) throw new Error(`${command} ${args.join(" ")} failed:\n${output}`);
	return output;
}

/**
 * Installs the packages of tests/readers/NAME.txt in build/NAME, unless they are installed; returns the Python that
 * has them.
 * @param {string} name
 * @param {string} program a Python with its venv
 */
export async function installed(name, program) {
	const folder = join(buildFolder, name);
	const python = join(folder, "venv/bin/python");
	const list = join(repository, `tests/readers/${name}.txt`);
	const stamp = join(folder, "installed.txt");
	const wanted = readFileSync(list, "utf8");
	if (existsSync(python) && existsSync(stamp) && readFileSync(stamp, "utf8") === wanted) return python;
	console.log(`Installing ${name} for Python …`);
	mkdirSync(folder, { recursive: true });
	rmSync(stamp, { force: true });
	try {
		await must(program, ["-m", "venv", "--clear", join(folder, "venv")]);
		await must(python, ["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--requirement", list]);
	} catch (error) {
		throw new Error(
			`What tests/readers/${name}.txt lists could not be installed into build/${name}; it takes ${program} and what pip fetches from PyPI.\n${error.message}`,
		);
	}
	writeFileSync(stamp, wanted);
	return python;
}

/**
 * Results of a reader (read.py) for files, in their order.
 * @param {string} python that has the reader
 * @param {"trimesh" | "blender" | "usd"} reader
 * @param {readonly string[]} files
 * @returns {Promise<{ count: number, bounds: [number[], number[]], closed?: boolean, complaints?: string[] }[]>}
 */
export async function readBy(python, reader, files) {
	const output = await must(python, [join(repository, "tests/readers/read.py"), reader, ...files]);
	return [...output.matchAll(/^READ (.*)$/gm)].map(([, found]) => JSON.parse(found));
}
