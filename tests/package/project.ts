/** Projects that use the package: empty folders outside the repository in which the tarball is installed. */
import { execFileSync } from "node:child_process";
import { cp, mkdir, mkdtemp, readFile, rm, symlink, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { makePackage } from "../../wasm-core/tools/package/make.mjs";

const repository = fileURLToPath(new URL("../../", import.meta.url));

export interface Project {
	readonly folder: string;
	/** Writes files by their names. */
	write(files: Readonly<Record<string, string>>): Promise<void>;
	/** Runs a script of the project in Node and returns its output. */
	run(script: string): string;
	/** Has a package of the repository's there too, as if it had been installed. */
	borrow(...packages: string[]): Promise<void>;
	remove(): Promise<void>;
}

/** The files that a page of the docs shows whole, by the names that it gives them: ```` ```js title="grow.mjs" ````. */
export async function filesOfPage(page = "docs/package.md"): Promise<Record<string, string>> {
	const text = await readFile(join(repository, page), "utf8");
	const blocks = text.matchAll(/^```\w+ title="([^"]+)"\n([\s\S]*?)^```$/gm);
	return Object.fromEntries([...blocks].map(([, name, code]) => [name, code]));
}

/** A project with the package in it, installed by npm without a network. */
export async function projectWith(files: Readonly<Record<string, string>>): Promise<Project> {
	const { tarball } = await makePackage();
	const folder = await mkdtemp(join(tmpdir(), "panicle-user-"));
	const write = async (more: Readonly<Record<string, string>>) => {
		for (const [name, text] of Object.entries(more)) {
			await mkdir(dirname(join(folder, name)), { recursive: true });
			await writeFile(join(folder, name), text);
		}
	};
	await write({ "package.json": '{ "name": "vineyard", "private": true, "type": "module" }\n', ...files });
	const quiet = ["--offline", "--no-audit", "--no-fund", "--silent"];
	execFileSync("npm", ["install", ...quiet, tarball], { cwd: folder, stdio: "pipe" });
	return {
		folder,
		write,
		run: (script) => execFileSync(process.execPath, [script], { cwd: folder, encoding: "utf8", stdio: "pipe" }),
		borrow: async (...packages) => {
			for (const name of packages) {
				const at = join(folder, "node_modules", name);
				await mkdir(dirname(at), { recursive: true });
				await symlink(join(repository, "node_modules", name), at);
			}
		},
		remove: () => rm(folder, { recursive: true, force: true }),
	};
}

/** Builds a project's page with Vite, as `npx vite build` does there. @returns the folder of the page */
export async function builtByVite(project: Project): Promise<string> {
	const vite = join(repository, "node_modules/vite/bin/vite.js");
	execFileSync(process.execPath, [vite, "build", "--logLevel", "error"], { cwd: project.folder, stdio: "pipe" });
	return join(project.folder, "dist");
}

/** Copies the installed package to where a server would have it. */
export async function vendored(project: Project, to: string): Promise<void> {
	await cp(join(project.folder, "node_modules/panicle"), to, { recursive: true });
}
