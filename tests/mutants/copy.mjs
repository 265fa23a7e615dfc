/**
 * A copy of the checkout, in build/, in which mutants are applied; the checkout itself is not changed. The copy stays
 * between runs, so that its builds are incremental.
 */
import { execFileSync, spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import {
	existsSync,
	mkdirSync,
	readdirSync,
	readFileSync,
	rmSync,
	statSync,
	symlinkSync,
	writeFileSync,
} from "node:fs";
import { dirname, join } from "node:path";
import { repository } from "../../wasm-core/tools/repository.mjs";

/** Of the checkout's build folder: the modules of models and of tests. */
const MODULES = ["build/core", "build/core-test"];

/** Files that generated code is made from, and those that make it. */
const GENERATES = /^wasm-core\/(parameters|grammars|tools\/generate)\b/;

/** A mutant of a table that the copy's own generator refuses. */
export class RefusedError extends Error {}

function checkoutFiles() {
	const listed = execFileSync("git", ["ls-files", "-z", "--cached", "--others", "--exclude-standard"], {
		cwd: repository,
		encoding: "utf8",
	});
	const modules = MODULES.filter((folder) => existsSync(join(repository, folder))).flatMap((folder) =>
		readdirSync(join(repository, folder)).map((name) => `${folder}/${name}`),
	);
	return [...listed.split("\0"), ...modules].filter((file) => file && existsSync(join(repository, file)));
}

/** Writes only changed files, so that builds are incremental. */
function bring(file, folder) {
	const bytes = readFileSync(join(repository, file));
	const to = join(folder, file);
	if (!existsSync(to) || !bytes.equals(readFileSync(to))) {
		mkdirSync(dirname(to), { recursive: true });
		writeFileSync(to, bytes);
	}
	return bytes;
}

/** Reads texts of files below a folder: of a folder all of its files', undefined where there is nothing. */
const reading = (root) => (path) => {
	const at = join(root, path);
	if (!existsSync(at)) return undefined;
	if (!statSync(at).isDirectory()) return readFileSync(at, "utf8");
	return readdirSync(at, { recursive: true, encoding: "utf8" })
		.sort()
		.map((name) => join(at, name))
		.filter((name) => statSync(name).isFile())
		.map((name) => readFileSync(name, "utf8"))
		.join("\n");
};

export const readCheckout = reading(repository);

export class Copy {
	/** The file that holds a mutant now, and its own text. @type {{ file: string, text: string } | undefined} */
	#mutated;

	/** @param {string} folder */
	constructor(folder) {
		this.folder = folder;
	}

	/** Updates the copy to the checkout; returns a hash of all its files. */
	refresh() {
		mkdirSync(this.folder, { recursive: true });
		const files = checkoutFiles();
		const hash = createHash("sha256");
		for (const file of files) hash.update(file).update(bring(file, this.folder));
		const record = join(this.folder, ".files.json");
		const before = existsSync(record) ? JSON.parse(readFileSync(record, "utf8")) : [];
		for (const file of before) if (!files.includes(file)) rmSync(join(this.folder, file), { force: true });
		writeFileSync(record, JSON.stringify(files));
		const packages = join(this.folder, "node_modules");
		if (!existsSync(packages)) symlinkSync(join(repository, "node_modules"), packages);
		this.#generate();
		return hash.digest("hex");
	}

	/** A text as it was when the copy was made: the checkout may go on while mutants are tried. */
	read = (path) => (path === this.#mutated?.file ? this.#mutated.text : reading(this.folder)(path));

	/** Brings the copy's generated code, which git does not list, up to date with its own tables. @throws RefusedError */
	#generate() {
		const command = ["wasm-core/tools/generate.mjs"];
		const { status, stderr } = spawnSync(process.execPath, command, { cwd: this.folder, encoding: "utf8" });
		if (status !== 0) throw new RefusedError(stderr);
	}

	/** Writes a file and the files generated from it. */
	#write({ file, text }) {
		writeFileSync(join(this.folder, file), text);
		if (GENERATES.test(file)) this.#generate();
	}

	/** Replaces a file's text, and restores the file that was mutated before. @throws RefusedError */
	mutate(file, text) {
		if (this.#mutated?.file !== file) {
			this.restore();
			this.#mutated = { file, text: this.read(file) };
		}
		this.#write({ file, text });
	}

	restore() {
		if (this.#mutated) this.#write(this.#mutated);
		this.#mutated = undefined;
	}
}
