/**
 * A folder in which a page's examples run: linked like a checkout, and like a site with the built app, the package and
 * three.js. Files that examples write stay in it.
 */
import { type ChildProcess, spawn } from "node:child_process";
import { mkdir, mkdtemp, readdir, rm, symlink, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { run } from "../../wasm-core/tools/process.mjs";
import { repository } from "../../wasm-core/tools/repository.mjs";
import type { Project } from "../package/project";
import { type Example, patternOf, plainly } from "./examples";

/** Progress messages of a long series. */
const SLOWLY = /^\d+ of \d+ plants\n/gm;

/** No colours: the test runner requests them through the environment. */
const { FORCE_COLOR: _, ...environment } = process.env;

/** Longest wait until a program is ready, milliseconds. */
const PATIENCE = 240_000;

/** Both outputs in their order, as a terminal shows them; ends with the first command that fails. */
const scriptOf = (code: string) => ["-ec", `exec 2>&1\n${code}`];

export class ExampleFolder {
	readonly #background: ChildProcess[] = [];

	private constructor(
		readonly folder: string,
		private readonly project: Project,
		private readonly python: string,
	) {}

	/** @param python has the packages of tests/readers/trimesh.txt */
	static async at(project: Project, python: string): Promise<ExampleFolder> {
		const folder = await mkdtemp(join(tmpdir(), "panicle-desk-"));
		for (const name of await readdir(repository)) {
			if (!name.startsWith(".")) await symlink(join(repository, name), join(folder, name));
		}
		await mkdir(join(folder, "vendor"));
		// Files of a host, as in docs/for-web-authors.md and for-game-developers.md.
		await symlink(join(repository, "dist"), join(folder, "panicle"));
		await symlink(join(project.folder, "node_modules/panicle"), join(folder, "vendor/panicle"));
		await symlink(join(repository, "node_modules/three"), join(folder, "vendor/three"));
		return new ExampleFolder(folder, project, python);
	}

	/**
	 * Runs an example; a page is only written. Throws where the example fails or its output differs from the
	 * documentation.
	 */
	async run(example: Example): Promise<void> {
		const { language, title = "", code } = example;
		if (language === "sh") {
			await (example.how === "background" ? this.#start(example) : this.#check(example, "sh", scriptOf(code)));
		} else if (language === "js") {
			await this.project.write({ [title]: code });
			await this.#check(example, process.execPath, [title], this.project.folder);
		} else {
			await writeFile(join(this.folder, title), code);
			if (language === "python") await this.#check(example, this.python, [title]);
		}
	}

	async #check(example: Example, program: string, words: string[], cwd = this.folder): Promise<void> {
		const { status, output } = await run(program, words, { cwd, env: environment });
		const printed = plainly(output.replace(SLOWLY, ""));
		const asDocumented = patternOf(example.prints ?? "").test(printed);
		if (status !== 0 || !asDocumented)
			throw new Error(`Line ${example.line}: status ${status}; it printed\n${printed}`);
	}

	/** Starts a program that keeps running, and waits for its documented output. */
	async #start({ code, prints = "", line }: Example): Promise<void> {
		const child = spawn("sh", scriptOf(code), {
			cwd: this.folder,
			env: environment,
			detached: true,
			stdio: ["ignore", "pipe", "inherit"],
		});
		this.#background.push(child);
		let printed = "";
		await new Promise<void>((resolve, reject) => {
			const late = () => reject(new Error(`Line ${line}: so far it printed\n${printed}`));
			const timer = setTimeout(late, PATIENCE);
			child.on("exit", late);
			child.stdout?.on("data", (piece) => {
				printed += piece;
				if (!patternOf(prints).test(plainly(printed))) return;
				clearTimeout(timer);
				resolve();
			});
		});
	}

	/** Ends running programs and removes all written files. */
	async clear(): Promise<void> {
		// Includes child processes: each program leads a process group.
		for (const { pid, exitCode } of this.#background) if (pid && exitCode === null) process.kill(-pid, "SIGTERM");
		await rm(this.folder, { recursive: true, force: true });
	}
}
