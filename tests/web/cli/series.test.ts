import { createHash } from "node:crypto";
import { unzipSync } from "fflate";
import { describe, expect, it } from "vitest";
import { run } from "../../../web/src/cli/run";
import { crc32Digits } from "../../../web/src/formats/crc32";
import { documentOf } from "../formats/reading";
import { complaint, grow, memoryWorld } from "./world";

const SMALL = ["redcurrant", "--set", "count=5", "--out", "d"];
const TABLE = "d/plants.csv";

type Files = Record<string, string | Uint8Array>;

/** Writes the series into a folder that already has these files; returns all files there afterwards. */
async function series(words: string[], before: Files = {}, environment: Record<string, string> = {}) {
	const memory = memoryWorld({}, environment);
	for (const [path, data] of Object.entries(before)) memory.written.set(path, data);
	const grown: string[] = [];
	const { replaceFile } = memory.world;
	const world = {
		...memory.world,
		replaceFile: (path: string, data: string | Uint8Array) => {
			if (!/\.csv|series\.json/.test(path)) grown.push(path);
			return replaceFile(path, data);
		},
	};
	const status = await run([...SMALL, ...words], world);
	return { status, grown, messages: memory.messages, files: Object.fromEntries(memory.written) };
}

/** Hashes of files, so that a comparison is short. */
const digests = (files: Files) =>
	Object.fromEntries(
		Object.entries(files).map(([path, data]) => [path, createHash("sha256").update(data).digest("hex")]),
	);

/** Cells by column; of these tables no cell holds a quotation mark. */
function zipped(names: string[], row: string): [string, string][] {
	const cells = [...row.matchAll(/(?:^|,)(?:"([^"]*)"|([^,]*))/g)].map(([, quoted, plain]) => quoted ?? plain);
	return names.map((name, at) => [name, cells[at]]);
}

function rowsOf(table: unknown): Record<string, string>[] {
	const [header, ...rows] = String(table).trimEnd().split("\r\n");
	return rows.map((row) => Object.fromEntries(zipped(header.split(","), row)));
}

describe("a series", () => {
	it("is a file for each seed and a table by which each comes back", async () => {
		const { status, files, messages } = await series(["--seeds", "1-3", "--vary", "age=60..110,density=3..8"]);
		expect(status).toBe(0);
		expect(Object.keys(files).sort()).toEqual([
			"d/plants.csv",
			"d/redcurrant-1.glb",
			"d/redcurrant-2.glb",
			"d/redcurrant-3.glb",
			"d/series.json",
		]);
		expect(messages).toEqual(["3 plants: 3 grown, 0 already there; d/plants.csv"]);
		const rows = rowsOf(files[TABLE]);
		expect(rows.map(({ number }) => number)).toEqual(["1", "2", "3"]);
		for (const { file, bytes, link, fingerprint, set_age, set_density, berry_count } of rows) {
			expect(Number(set_age)).toBeGreaterThanOrEqual(60);
			expect(Number(set_age)).toBeLessThanOrEqual(110);
			const glb = files[`d/${file}`] as Uint8Array;
			expect(glb).toHaveLength(Number(bytes));
			const { json, written } = await grow([link]);
			expect(json.fingerprint).toBe(fingerprint);
			expect(json.specimen.parameters).toMatchObject({ age: Number(set_age), density: Number(set_density), count: 5 });
			expect(json.measures.berry_count).toBe(Number(berry_count));
			expect(written.size).toBe(0);
			const alone = (await grow([link, "--out", "one.glb"])).written.get("one.glb") as Uint8Array;
			expect(digests({ alone })).toEqual(digests({ alone: glb }));
		}
		expect(new Set(rows.map(({ set_age }) => set_age)).size).toBe(3);
	});

	it("is of any model, and of any kind of file", async () => {
		const { status, written } = await grow(["leaf/oak", "--set", "n=60", "--seeds", "5", "--as", "svg", "--out", "d"]);
		expect(status).toBe(0);
		expect([...written.keys()].sort()).toEqual(["d/oak-5-veins.svg", "d/plants.csv", "d/series.json"]);
		const { files } = await series(["--seeds", "5", "--as", "obj"]);
		expect(Object.keys(unzipSync(files["d/redcurrant-5-obj.zip"] as Uint8Array))).toContain("redcurrant-5.obj");
	});

	it("is of several kinds of files at once, each with its column, and of options of theirs", async () => {
		const words = ["--seeds", "1-2", "--as", "json,ply", "--as", "glb-low", "--points", "50", "--triangles", "300"];
		const whole = await series(words);
		expect(whole.status).toBe(0);
		const names = ["json", "ply", "glb"].flatMap((end) =>
			[1, 2].map((n) => `redcurrant-${n}${end === "glb" ? "-low" : ""}.${end}`),
		);
		expect(Object.keys(whole.files).sort()).toEqual(
			["plants.csv", ...names, "series.json"].map((name) => `d/${name}`).sort(),
		);
		const [row] = rowsOf(whole.files[TABLE]);
		expect(row).toMatchObject({
			file: "redcurrant-1.json",
			file_ply: "redcurrant-1.ply",
			"file_glb-low": "redcurrant-1-low.glb",
		});
		const ply = whole.files["d/redcurrant-1.ply"] as Uint8Array;
		expect([Number(row.bytes_ply), row.crc32_ply]).toEqual([ply.length, crc32Digits(ply)]);
		expect(new TextDecoder("latin1").decode(ply)).toContain("element vertex 50\n");
		const alone = await grow([row.link, "--triangles", "300", "--form", "low", "--out", "one.glb"]);
		expect(digests({ a: alone.written.get("one.glb") as Uint8Array })).toEqual(
			digests({ a: whole.files["d/redcurrant-1-low.glb"] }),
		);
		const { "d/redcurrant-2.ply": _, ...rest } = whole.files;
		const again = await series(words, rest);
		expect(again.messages).toEqual(["2 plants: 1 grown, 1 already there; d/plants.csv"]);
		expect(digests(again.files)).toEqual(digests(whole.files));
	});

	it("has codes and classes of the OIV's descriptors, as the JSON has them", async () => {
		const { files } = await series(["--seeds", "3", "--as", "json"]);
		const [row] = rowsOf(files[TABLE]);
		const { classes } = JSON.parse(new TextDecoder().decode(files["d/redcurrant-3.json"] as Uint8Array));
		const codes = Object.keys(row).flatMap((column) => /^oiv_(\d+)_class$/.exec(column)?.[1] ?? []);
		expect(codes).toEqual(expect.arrayContaining(["202", "204", "220", "223", "225", "502"]));
		for (const code of codes) {
			const found = Object.values(classes as Record<string, { oiv: number; class: number; words: string }>).find(
				({ oiv }) => oiv === Number(code),
			);
			const written = [row[`oiv_${code}_class`], row[`oiv_${code}_words`]];
			expect(written).toEqual(found ? [String(found.class), found.words] : ["", ""]);
		}
	});

	it("has no time of day or of work in it: grown again, all is the same", async () => {
		const words = ["--seeds", "1-2", "--as", "json"];
		const [one, other] = [await series(words), await series(words)];
		expect(digests(other.files)).toEqual(digests(one.files));
	});
});

describe("parts of a series", () => {
	const words = ["--seeds", "1-3,10-13", "--vary", "age=60..110"];

	it("are together the whole, byte for byte", async () => {
		const whole = await series(words);
		for (const total of [2, 3]) {
			const parts: Files = {};
			let table = "";
			for (let part = 1; part <= total; part++) {
				const { files } = await series([...words, "--shard", `${part}/${total}`]);
				const name = `d/plants-${part}-of-${total}.csv`;
				const { [name]: lines, "d/series.json": manifest, ...others } = files;
				expect(JSON.parse(String(manifest))).toMatchObject({ plants: "1-3,10-13", parts: total });
				table += part === 1 ? lines : String(lines).slice(String(lines).indexOf("\r\n") + 2);
				for (const file of Object.keys(others)) expect(parts).not.toHaveProperty([file]);
				Object.assign(parts, others);
			}
			const { "d/series.json": _, ...files } = whole.files;
			expect(digests({ ...parts, [TABLE]: table })).toEqual(digests(files));
		}
	});

	it("are found by the variables of a Slurm array and of a Kubernetes Job", async () => {
		const second = await series([...words, "--shard", "2/3"]);
		const slurm = { SLURM_ARRAY_TASK_ID: "5", SLURM_ARRAY_TASK_MIN: "4", SLURM_ARRAY_TASK_COUNT: "3" };
		expect(digests((await series([...words, "--shard", "auto"], {}, slurm)).files)).toEqual(digests(second.files));
		const job = { JOB_COMPLETION_INDEX: "1" };
		expect(digests((await series([...words, "--shard", "auto/3"], {}, job)).files)).toEqual(digests(second.files));
	});

	it("may be empty, where there are more of them than plants", async () => {
		const { status, files } = await series(["--seeds", "1", "--shard", "1/2"]);
		expect([status, Object.keys(files)]).toEqual([0, ["d/series.json", "d/plants-1-of-2.csv"]]);
	});
});

describe("a series that was broken off", () => {
	const words = ["--seeds", "1-4", "--vary", "age=60..110"];

	it("grows what is not there or not whole, and nothing else", async () => {
		const whole = await series(words);
		const again = await series(words, whole.files);
		expect([again.grown, digests(again.files)]).toEqual([[], digests(whole.files)]);
		expect(again.messages).toEqual(["4 plants: 0 grown, 4 already there; d/plants.csv"]);

		const glb = whole.files["d/redcurrant-2.glb"] as Uint8Array;
		const flipped = glb.slice();
		flipped[flipped.length >> 1] ^= 1;
		const { "d/redcurrant-3.glb": _, ...rest } = whole.files;
		for (const harmed of [flipped, glb.slice(0, -1)]) {
			const { grown, files } = await series(words, { ...rest, "d/redcurrant-2.glb": harmed });
			expect(grown).toEqual(["d/redcurrant-2.glb", "d/redcurrant-3.glb"]);
			expect(digests(files)).toEqual(digests(whole.files));
		}
	});

	it("goes on from its journal, whose last line may be half a line", async () => {
		const whole = await series(words);
		const lines = String(whole.files[TABLE]).split("\r\n");
		const journal = `${lines.slice(0, 3).join("\r\n")}\r\n${lines[3].slice(0, 40)}`;
		const { [TABLE]: __, ...files } = whole.files;
		const { grown, files: after } = await series(words, { ...files, [`${TABLE}.part`]: journal });
		expect(grown).toEqual(["d/redcurrant-3.glb", "d/redcurrant-4.glb"]);
		expect(digests(after)).toEqual(digests(whole.files));
	});
});

it("what does not grow leaves a line that says why, and is tried again", async () => {
	const memory = memoryWorld();
	let broken = true;
	const loadCore: typeof memory.world.loadCore = async (wasm) => {
		const core = await memory.world.loadCore(wasm);
		const grow: typeof core.grow = (blocks) => {
			if (!broken) return core.grow(blocks);
			broken = false;
			throw new Error("the core broke");
		};
		return Object.defineProperties(Object.create(core), { grow: { value: grow }, memoryBytes: { value: 0 } });
	};
	const words = [...SMALL, "--seeds", "1-2"];
	expect(await run(words, { ...memory.world, loadCore })).toBe(1);
	expect(memory.messages.at(-1)).toBe(
		"grow: 1 plant could not be grown. The table’s “notes” column gives the reasons.",
	);
	const rows = rowsOf(memory.written.get(TABLE));
	expect(rows.map(({ file, notes }) => [file, notes])).toEqual([
		["", "the core broke"],
		["redcurrant-2.glb", ""],
	]);
	expect(await run(words, memory.world)).toBe(0);
	expect(memory.messages.at(-1)).toBe("2 plants: 1 grown, 1 already there; d/plants.csv");
});

it("a series in GLB has what each GLB says of itself", async () => {
	const { files } = await series(["--seeds", "7"]);
	const [{ link, seed }] = rowsOf(files[TABLE]);
	expect(link).toContain(`seed=${seed}`);
	expect(JSON.stringify(documentOf(files["d/redcurrant-7.glb"] as Uint8Array))).toContain(
		JSON.stringify(link).slice(1, -1),
	);
});

describe("what of a series cannot be used", () => {
	const refused = (words: string[], environment = {}) => complaint([...SMALL, ...words], {}, environment);

	it.each([
		[["--seeds", "x"], "--seeds x: “x” is not a number or a range. Try 1-100 or 1,5,9."],
		[["--seeds", "9-1"], "--seeds 9-1: The range 9-1 is reversed. Write 1-9."],
		[["--seeds", "1-4294967296"], "--seeds 1-4294967296: 4294967296 is too large. The largest number is 4294967295."],
		[["--seeds", "0-200000"], /^--seeds 0-200000: A series can have at most 100,000 plants\. Make several series/],
		[["--seeds", "1", "--seed", "2"], "Use either --seed or --seeds."],
		[["--vary", "age=1..2"], "--vary: This option needs a series. Add --seeds, as in --seeds 1-100."],
		[["--seeds", "1", "--vary", "age"], /“age” cannot be read\. Write KEY=FROM..TO or KEY=ONE\|ANOTHER/],
		[["--seeds", "1", "--vary", "plum=1..2"], /There is no parameter plum\./],
		[["--seeds", "1", "--vary", "age=60..20"], /The range age=60\.\.20 is reversed\. Write age=20\.\.60\./],
		[["--seeds", "1", "--vary", "age=60..900"], /age: 900 is above the maximum, 125/],
		[["--seeds", "1", "--vary", "age=60..x"], /age: “x” is not a number/],
		[["--seeds", "1", "--vary", "age=1.234..9"], /age: 1\.234 has more than two decimals/],
		[["--seeds", "1", "--vary", "p3=79,76"], /p3 consists of several numbers\. Vary one of p3w or p3r\./],
		[["--seeds", "1", "--vary", "fruit=0..2"], /fruit cannot be given as a range\. Write fruit=/],
		[["--seeds", "1", "--vary", "thin=a"], /thin is not a parameter, so it cannot vary\./],
		[["--seeds", "1", "--vary", "age=1..2,age=3..4"], /age is given twice/],
		[
			["--seeds", "1", "--as", "fbx"],
			/There is no file format “fbx” for this plant\. The formats are glb, glb-web, glb-low, .*, obj, json, csv, csv-measures/,
		],
		[
			["--seeds", "1", "--triangles", "300"],
			/--triangles: This option applies to glb-low and glb-wind and has no effect on glb/,
		],
		[
			["--seeds", "1", "--boundary", "box.obj"],
			/--boundary: This option is only for a single plant, .* cannot hold meshes/,
		],
		[["--points", "10.5"], /^--points must be a whole number from 1 to/],
		[["--triangles", "1000.5"], /^--triangles must be a whole number from 100 to/],
		[["--seeds", "1", "--shard", "4/3"], /--shard 4\/3: There is no part 4 of 3\./],
		[["--seeds", "1", "--shard", "0/0"], /The number of parts must be from 1 to 10,000, not 0\./],
		[["--seeds", "1", "--shard", "third"], /“third” cannot be read\. Write PART\/PARTS, as in 3\/16/],
		[["--seeds", "1", "--shard", "auto"], /Neither SLURM_ARRAY_TASK_ID nor JOB_COMPLETION_INDEX is set/],
	])("%j", async (words, messages) => {
		expect(await refused(words as string[])).toMatch(messages);
	});

	it("is told where the variables of an engine do not give a place", async () => {
		const auto = ["--seeds", "1", "--shard"];
		const slurm = { SLURM_ARRAY_TASK_ID: "7", SLURM_ARRAY_TASK_MIN: "1", SLURM_ARRAY_TASK_COUNT: "3" };
		expect(await refused([...auto, "auto"], slurm)).toMatch(
			/Task 7 is not one of the 3 tasks numbered from 1\. Number the array without gaps/,
		);
		expect(await refused([...auto, "auto/4"], { ...slurm, SLURM_ARRAY_TASK_ID: "2" })).toMatch(
			/The Slurm array has 3 tasks, not 4/,
		);
		expect(await refused([...auto, "auto"], { JOB_COMPLETION_INDEX: "1" })).toMatch(/as in auto\/16 for 16 parts/);
	});

	it("is a folder that is missing or cannot be written", async () => {
		expect(await complaint(["rubus", "--seeds", "1"])).toBe(
			"--seeds: A series needs a folder for its files: --out DIR.",
		);
		expect(await complaint(["rubus", "--seeds", "1", "--out", "nowhere"])).toMatch(
			/^--out nowhere\/series\.json: There is no such/,
		);
	});
});
