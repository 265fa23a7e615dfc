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

export class Copy {
	/** @param {string} folder */
	constructor(folder) {
		this.folder = folder;
		/** The file that holds a mutant now. @type {string | undefined} */
		this.mutated = undefined;
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

	/** Puts a text in place of a file's, and back what was mutated before. */
	mutate(file, text) {
		if (this.mutated !== file) this.restore();
		this.mutated = file;
		writeFileSync(join(this.folder, file), text);
	}

	restore() {
		if (this.mutated) bring(this.mutated, this.folder);
		this.mutated = undefined;
	}
}

/** The text of a file of the checkout, or of all files of a folder; undefined where there is none. */
export function readCheckout(path) {
	const at = join(repository, path);
	if (!existsSync(at)) return undefined;
	if (!statSync(at).isDirectory()) return readFileSync(at, "utf8");
	return readdirSync(at, { recursive: true, encoding: "utf8" })
		.sort()
		.map((name) => join(at, name))
		.filter((name) => statSync(name).isFile())
		.map((name) => readFileSync(name, "utf8"))
		.join("\n");
}
