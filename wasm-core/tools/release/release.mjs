/**
 * Writes a release: the published files of one commit, and their SHA-256 checksums. The same commit gives the same
 * bytes under the same version of Node.
 */
import { createHash } from "node:crypto";
import { copyFileSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { capture } from "../process.mjs";
import { ToolchainError } from "../toolchain.mjs";

/** Date of all entries of an archive: the earliest that archives can hold. */
const DATE = new Date(1980, 0, 1);
const SUMS = "SHA256SUMS";

/**
 * @typedef {object} Makers
 * @property {() => Promise<string>} app builds the app; the folder that it is in
 * @property {() => Promise<string>} tarball makes the package; the file that it is
 */

/**
 * Writes a release into `out`, which is emptied before: the app as an archive, the package, what has changed, and the sums of these.
 *
 * @param {{ root: string, out: string, make: Makers }} options root: of the repository
 * @returns {Promise<string[]>} the files' names
 */
export async function writeRelease({ root, out, make }) {
	const { version } = JSON.parse(readFileSync(join(root, "package.json"), "utf8"));
	checkClean(root);
	const changes = changesOf(readFileSync(join(root, "CHANGELOG.md"), "utf8"), version);
	const commit = capture("git", ["-C", root, "rev-parse", "HEAD"])?.trim();
	const [app, tarball] = [await make.app(), await make.tarball()];
	// The build may rewrite committed files, such as a page of docs: then these were out of date.
	checkClean(root);
	rmSync(out, { recursive: true, force: true });
	mkdirSync(out, { recursive: true });
	writeFileSync(join(out, `panicle-app-${version}.zip`), await archive(app, `panicle-app-${version}`));
	copyFileSync(tarball, join(out, basename(tarball)));
	writeFileSync(join(out, "CHANGES.md"), `# Panicle ${version}\n\nOf commit ${commit}.\n\n${changes}\n`);
	const files = readdirSync(out).sort();
	writeFileSync(join(out, SUMS), files.map((file) => `${sumOf(join(out, file))}  ${file}\n`).join(""));
	return [...files, SUMS];
}

/** Throws a ToolchainError if there are uncommitted changes: a release contains only committed files. */
function checkClean(root) {
	const status = capture("git", ["-C", root, "status", "--porcelain"]);
	if (status === null)
		throw new ToolchainError("release: this is no checkout of git, so that nobody could tell what went into it.");
	const files = status.split("\n").filter(Boolean);
	if (files.length === 0) return;
	const more = files.length > 10 ? [`   and ${files.length - 10} more`] : [];
	throw new ToolchainError(
		[
			"release: these files are not as they were committed; commit them or take them back.",
			...files.slice(0, 10),
			...more,
		].join("\n"),
	);
}

/** Returns a version's section of the changelog, without its heading. */
function changesOf(changelog, version) {
	const sections = changelog.split(/^(?=## \[)/m).slice(1);
	const own = sections.find((section) => section.startsWith(`## [${version}]`));
	const text = own?.split("\n").slice(1).join("\n").trim();
	if (text) return text;
	throw new ToolchainError(
		`release: CHANGELOG.md says nothing of ${version}; write a section “## [${version}] - DATE”.`,
	);
}

/** Returns a folder as a ZIP in a folder of that name: the same files give the same bytes. */
async function archive(folder, name) {
	const { zipSync } = await import("fflate");
	const files = readdirSync(folder, { recursive: true, withFileTypes: true })
		.filter((entry) => entry.isFile())
		.map((entry) => join(entry.parentPath, entry.name))
		.map((file) => [
			`${name}/${file.slice(folder.length + 1).replaceAll("\\", "/")}`,
			new Uint8Array(readFileSync(file)),
		])
		.sort(([one], [other]) => (one < other ? -1 : 1));
	return zipSync(Object.fromEntries(files), { level: 9, mtime: DATE });
}

const sumOf = (file) => createHash("sha256").update(readFileSync(file)).digest("hex");
