import { execFileSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdir, mkdtemp, readdir, readFile, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { strFromU8, unzipSync } from "fflate";
import { afterEach, beforeEach, describe, expect, it } from "vitest";
import { writeRelease } from "../../wasm-core/tools/release/release.mjs";
import { repository } from "../../wasm-core/tools/repository.mjs";

const CHANGES =
	"# Changelog\n\n## [Unreleased]\n\n- Later\n\n## [2.0.0] - 2026-01-02\n\n### Added\n\n- Figs\n\n## [1.0.0] - 2026-01-01\n\n- Grapes\n";

/** A repository of three files, whose app and package are made of texts. */
let root: string;
let made: number;
const git = (...words: string[]) =>
	execFileSync("git", ["-C", root, "-c", "user.name=A", "-c", "user.email=a@b.example", ...words], {
		encoding: "utf8",
	});
const write = (file: string, text: string) => writeFile(join(root, file), text);

beforeEach(async () => {
	root = await mkdtemp(join(tmpdir(), "panicle-release-"));
	made = 0;
	await write("package.json", '{ "version": "2.0.0" }');
	await write("CHANGELOG.md", CHANGES);
	await write(".gitignore", "build/\n");
	git("init", "--quiet");
	git("add", ".");
	git("commit", "--quiet", "-m", "project: Begin");
});
afterEach(() => rm(root, { recursive: true, force: true }));

const make = {
	app: async () => {
		made++;
		const folder = join(root, "build/app");
		await mkdir(join(folder, "assets"), { recursive: true });
		// In another order and at another time with every build.
		const files = ["index.html", "assets/b.js", "assets/a.js"];
		for (const file of made % 2 ? files : files.reverse()) await writeFile(join(folder, file), `of ${file}`);
		return folder;
	},
	tarball: async () => {
		await write("build/panicle-2.0.0.tgz", "package");
		return join(root, "build/panicle-2.0.0.tgz");
	},
};
const release = (out = "build/release") => writeRelease({ root, out: join(root, out), make });
const bytesIn = async (out: string) => {
	const files = (await readdir(join(root, out))).sort();
	return Promise.all(files.map(async (file) => [file, (await readFile(join(root, out, file))).toString("base64")]));
};

describe("a release", () => {
	it("is the app, the package and what has changed, with sums that verify", async () => {
		const files = await release();
		expect(files).toEqual(["CHANGES.md", "panicle-2.0.0.tgz", "panicle-app-2.0.0.zip", "SHA256SUMS"]);
		const read = (file: string) => readFile(join(root, "build/release", file));
		const sums = (await read("SHA256SUMS")).toString().trim().split("\n");
		expect(sums).toHaveLength(3);
		for (const line of sums) {
			const [sum, file] = line.split("  ");
			expect(
				createHash("sha256")
					.update(await read(file))
					.digest("hex"),
			).toBe(sum);
		}
		const app = unzipSync(new Uint8Array(await read("panicle-app-2.0.0.zip")));
		// In this order, independently of the file system's.
		expect(Object.entries(app).map(([name, bytes]) => [name, strFromU8(bytes)])).toEqual([
			["panicle-app-2.0.0/assets/a.js", "of assets/a.js"],
			["panicle-app-2.0.0/assets/b.js", "of assets/b.js"],
			["panicle-app-2.0.0/index.html", "of index.html"],
		]);
		const changes = (await read("CHANGES.md")).toString();
		expect(changes).toContain(git("rev-parse", "HEAD").trim());
		expect(changes).toMatch(/Figs/);
		expect(changes).not.toMatch(/Later|Grapes/);
	});

	it("has the same bytes when it is made again", async () => {
		await release("build/one");
		await new Promise((resolve) => setTimeout(resolve, 20));
		await release("build/other");
		expect(await bytesIn("build/other")).toEqual(await bytesIn("build/one"));
	});

	it("is refused where something is not committed, before anything is built", async () => {
		await write("notes.txt", "later");
		await write("package.json", '{ "version": "2.0.0", "private": true }');
		await expect(release()).rejects.toThrow(/not as they were committed[\s\S]*package\.json[\s\S]*notes\.txt/);
		expect(made).toBe(0);
		git("checkout", "--quiet", "package.json");
		await rm(join(root, "notes.txt"));
		await expect(release()).resolves.toHaveLength(4);
	});

	it("is refused where building changes what is committed", async () => {
		const stale = { ...make, tarball: () => write("CHANGELOG.md", `${CHANGES}\n`).then(make.tarball) };
		await expect(writeRelease({ root, out: join(root, "build/release"), make: stale })).rejects.toThrow(
			/CHANGELOG\.md/,
		);
		expect(await readdir(join(root, "build"))).not.toContain("release");
	});

	it("is refused where nobody has said what is new in it", async () => {
		await write("package.json", '{ "version": "2.0.1" }');
		git("commit", "--quiet", "-am", "project: Number");
		await expect(release()).rejects.toThrow("CHANGELOG.md says nothing of 2.0.1; write a section “## [2.0.1] - DATE”.");
	});
});

it("the changelog has a section for what is to come and for the version that the sources have", async () => {
	const changelog = await readFile(join(repository, "CHANGELOG.md"), "utf8");
	const { version } = JSON.parse(await readFile(join(repository, "package.json"), "utf8"));
	const sections = [...changelog.matchAll(/^## \[([^\]]+)\](?: - (\d{4}-\d\d-\d\d))?$/gm)].map(([, name, date]) => [
		name,
		date,
	]);
	expect(sections[0]).toEqual(["Unreleased", undefined]);
	expect(sections[1][0]).toBe(version);
	expect(sections.slice(1).filter(([, date]) => !date)).toEqual([]);
	const headings = new Set([...changelog.matchAll(/^### (.*)$/gm)].map(([, heading]) => heading));
	const allowed = ["Added", "Sizes", "Changed", "Deprecated", "Removed", "Fixed", "Security"];
	expect([...headings].filter((heading) => !allowed.includes(heading))).toEqual([]);
});
