/**
 * A copy of the checkout, in build/, in which mutants are made: the checkout itself is never touched. It stays from run to
 * run, so that what is built in it is built once.
 */
import { execFileSync } from "node:child_process";
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

/** Writes only what differs, so that builds see only what has changed. */
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

	/** Makes the copy what the checkout is now; returns a hash of everything in it. */
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
		return hash.digest("hex");
	}

	/** A text as it was when the copy was made: the checkout may go on while mutants are tried. */
	read = (path) => (path === this.#mutated?.file ? this.#mutated.text : reading(this.folder)(path));

	/** Puts a text in place of a file's, and back what was mutated before. */
	mutate(file, text) {
		if (this.#mutated?.file !== file) {
			this.restore();
			this.#mutated = { file, text: this.read(file) };
		}
		writeFileSync(join(this.folder, file), text);
	}

	restore() {
		if (this.#mutated) writeFileSync(join(this.folder, this.#mutated.file), this.#mutated.text);
		this.#mutated = undefined;
	}
}
