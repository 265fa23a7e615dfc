import { execFileSync, spawn } from "node:child_process";
import { cp, mkdtemp, readdir, readFile, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { afterAll, beforeAll, expect, it } from "vitest";
import { isLongRun } from "../../long_run.mjs";
import { restore, specimenFromPreset } from "../bunch";
import { freshCore, growBunch } from "../core/wasm";

const repository = fileURLToPath(new URL("../../../", import.meta.url));
let folder = "";

/** Runs the command as `npm run grow` does. */
function grow(...words: string[]): Promise<{ status: number | null; out: string; err: string }> {
	return new Promise((resolve, reject) => {
		const child = spawn(process.execPath, ["wasm-core/tools/grow.mjs", ...words], { cwd: repository });
		let out = "";
		let err = "";
		child.stdout.on("data", (data) => {
			out += data;
		});
		child.stderr.on("data", (data) => {
			err += data;
		});
		child.on("error", reject);
		child.on("close", (status) => resolve({ status, out, err }));
	});
}

beforeAll(async () => {
	folder = await mkdtemp(join(tmpdir(), "panicle-cli-"));
});

afterAll(() => rm(folder, { recursive: true, force: true }));

it("grows what the core grows, and prints the JSON alone", async () => {
	const { status, out, err } = await grow("short-conical", "--seed", "7");
	expect({ status, err }).toEqual({ status: 0, err: "" });
	const specimen = { ...specimenFromPreset("short-conical"), seed: 7 };
	const { fingerprint, counts } = growBunch(await freshCore(), specimen);
	const printed = JSON.parse(out);
	expect(printed).toMatchObject({ fingerprint, counts });
	expect(restore(printed.specimen).specimen).toEqual(specimen);
});

it.runIf(isLongRun)("writes files", async () => {
	const file = join(folder, "bunch.glb");
	const { status, out } = await grow("rubus", "--out", file);
	expect({ status, out }).toEqual({ status: 0, out: "" });
	expect((await readFile(file)).subarray(0, 4).toString()).toBe("glTF");
});

it("ends with 2 and one line where the call cannot be used", async () => {
	const { status, out, err } = await grow("--set", "l=x");
	expect({ status, out, err }).toEqual({ status: 2, out: "", err: "grow: --set l: “x” is not a number.\n" });
});

it.runIf(isLongRun)("grows a series into a folder that it makes, and goes on where it was broken off", async () => {
	const into = join(folder, "not/yet");
	const words = ["redcurrant", "--set", "count=5", "--seeds", "1-2", "--out", into];
	const first = await grow(...words);
	const last = (lines: string) => lines.trimEnd().split("\n").at(-1);
	expect({ ...first, err: last(first.err) }).toEqual({
		status: 0,
		out: "",
		err: `2 plants: 2 grown, 0 already there; ${join(into, "plants.csv")}`,
	});
	expect((await readdir(into)).sort()).toEqual(["plants.csv", "redcurrant-1.glb", "redcurrant-2.glb", "series.json"]);
	await rm(join(into, "redcurrant-2.glb"));
	const again = await grow(...words);
	expect(last(again.err)).toBe(`2 plants: 1 grown, 1 already there; ${join(into, "plants.csv")}`);
	expect(await readdir(into)).toHaveLength(4);
});

it.runIf(isLongRun)("is all in what the container file copies", async () => {
	const image = join(folder, "image");
	const stages = (await readFile(join(repository, "Containerfile"), "utf8")).split(/^FROM /m);
	const lines = stages.find((stage) => /^\S+ AS command\n/.test(stage))?.split("\n") ?? [];
	for (const [, from, to] of lines.flatMap((line) => [
		...line.matchAll(/^COPY --from=build \/panicle\/(\S+) (\S+)$/g),
	])) {
		await cp(join(repository, from), join(image, to), { recursive: true });
	}
	const entry = lines.find((line) => line.startsWith("ENTRYPOINT "))?.slice("ENTRYPOINT ".length);
	const [program, ...words] = JSON.parse(entry ?? "[]") as string[];
	expect(program).toBe("node");
	const series = ["leaf/lime", "--set", "n=40", "--seeds", "1", "--as", "obj", "--out", "out"];
	execFileSync(process.execPath, [...words, ...series], { cwd: image, stdio: "pipe" });
	expect((await readdir(join(image, "out"))).sort()).toEqual(["lime-1-obj.zip", "plants.csv", "series.json"]);
});

it.runIf(isLongRun)("keeps still when its reader has seen enough", async () => {
	const child = spawn("sh", ["-c", `"${process.execPath}" wasm-core/tools/grow.mjs long-conical | head -c 10`], {
		cwd: repository,
	});
	let err = "";
	child.stderr.on("data", (data) => {
		err += data;
	});
	await new Promise((resolve) => child.on("close", resolve));
	expect(err).toBe("");
});
