/** A folder of a series: it holds one series, and one process at a time writes its table. */
import { describe, expect, it } from "vitest";
import { run } from "../../../web/src/cli/run";
import type { CommandEnvironment } from "../../../web/src/cli/surroundings";
import { memoryWorld } from "./world";

const SMALL = ["redcurrant", "--set", "count=5", "--as", "json", "--out", "d"];
const TABLE = "d/plants.csv";
const LOCK = "d/plants.csv.lock";

type Written = Map<string, string | Uint8Array>;

/** The command in a process of its own, in a folder that others may write to. */
async function series(
	words: readonly string[],
	written: Written = new Map(),
	differs: Partial<CommandEnvironment> = {},
) {
	const { world, messages } = memoryWorld({}, {}, written);
	const status = await run([...SMALL, ...words], { ...world, ...differs });
	return { status, messages, written };
}

const textOf = (written: Written, path: string) => {
	const data = written.get(path);
	return typeof data === "string" ? data : new TextDecoder().decode(data);
};
const rowsIn = (written: Written, table = TABLE) => textOf(written, table).trimEnd().split("\r\n").slice(1);
const copied = (written: Written): Written => new Map(written);

describe("two that are started together into one new folder", () => {
	it("of different series: one is grown whole, the other refused", async () => {
		const written: Written = new Map();
		const both = await Promise.all([series(["--seeds", "1-3"], written), series(["--seeds", "4-6"], written)]);
		expect(both.map(({ status }) => status).sort()).toEqual([0, 2]);
		const refused = both.find(({ status }) => status === 2);
		expect(refused?.messages).toEqual([
			expect.stringMatching(
				/^grow: --out d: The folder contains a different series \(--seeds: \S+ in the folder, \S+ now\)/,
			),
		]);
		const numbers = rowsIn(written).map((row) => row.split(",")[0]);
		expect(["1 2 3", "4 5 6"]).toContain(numbers.join(" "));
		expect([...written.keys()].filter((path) => path.startsWith("d/redcurrant"))).toHaveLength(3);
	});

	it("of the same series: one grows it, the other is refused while it does", async () => {
		const written: Written = new Map();
		const both = await Promise.all([series(["--seeds", "1-3"], written), series(["--seeds", "1-3"], written)]);
		expect(both.map(({ status }) => status).sort()).toEqual([0, 2]);
		expect(both.flatMap(({ messages }) => messages)).toContainEqual(
			expect.stringMatching(
				/^grow: --out d\/plants\.csv: Process \d+ on here is writing this table \(last active 0 s ago\)\. Wait until it has finished\.$/,
			),
		);
		expect(rowsIn(written)).toHaveLength(3);
		expect(written.has(LOCK)).toBe(false);
		expect((await series(["--seeds", "1-3"], written)).messages).toEqual([
			"3 plants: 0 grown, 3 already there; d/plants.csv",
		]);
	});

	it("that are parts of one series: both are grown", async () => {
		const written: Written = new Map();
		const parts = ["1/2", "2/2"].map((part) => series(["--seeds", "1-4", "--shard", part], written));
		expect((await Promise.all(parts)).map(({ status }) => status)).toEqual([0, 0]);
		expect([1, 2].map((part) => rowsIn(written, `d/plants-${part}-of-2.csv`).length)).toEqual([2, 2]);
	});
});

describe("a folder that holds another series", () => {
	const words = ["--seeds", "1-3", "--vary", "age=60..110"];

	it.each([
		[["--seeds", "2-3", "--vary", "age=60..110"], "--seeds: 1-3 in the folder, 2-3 now"],
		[["--seeds", "1-12", "--vary", "age=60..110"], "--seeds: 1-3 in the folder, 1-12 now"],
		[["--seeds", "1-3", "--vary", "age=60..100"], "--vary age: 60..110 in the folder, 60..100 now"],
		[["--seeds", "1-3"], "--vary age: 60..110 in the folder, not given now"],
		[[...words, "--set", "density=3"], "--set density: not given in the folder, 3 now"],
		[[...words, "--set", "count=6"], "--set count: 5 in the folder, 6 now"],
		[[...words, "--as", "csv"], "--as: json in the folder, json,csv now"],
		[[...words, "--literal-seeds"], "draws: independent in the folder, literal now"],
		[[...words, "--shard", "1/2"], "parts of --shard: 1 in the folder, 2 now"],
		[[...words, "--target", "berry_width=8"], "--target berry_width: not given in the folder, 8 now"],
	])("is left as it is, and the difference named: %j", async (others, difference) => {
		const { written } = await series(words);
		const before = copied(written);
		const { status, messages } = await series(others, written);
		expect(status).toBe(2);
		expect(messages).toEqual([
			`grow: --out d: The folder contains a different series (${difference}). Choose another folder.`,
		]);
		expect(written).toEqual(before);
	});

	it("is known by its preset, its program and its text as well", async () => {
		const { written } = await series(words);
		const texts = { "one.lsys": "axiom: F(10)[+F(5)]\n", "other.lsys": "axiom: F(10)[-F(5)]\n" };
		const { world, messages } = memoryWorld(texts, {}, written);
		expect(await run(["leaf/oak", "--seeds", "1-3", "--out", "d", "--as", "json"], world)).toBe(2);
		expect(messages[0]).toContain("preset: bunch/redcurrant in the folder, leaf/oak now");
		const grow = (text: string) => run(["--grammar", text, "--seeds", "1", "--as", "json", "--out", "e"], world);
		expect([await grow("one.lsys"), await grow("other.lsys")]).toEqual([0, 2]);
		expect(messages.at(-1)).toMatch(
			/^grow: --out e: The folder contains a different series \(text \w+: a different value in the folder, a different value now\)/,
		);

		const older = JSON.parse(textOf(written, "d/series.json"));
		written.set("d/series.json", JSON.stringify({ ...older, program: "Panicle 0.0.1" }));
		expect((await series(words, written)).messages[0]).toMatch(
			/program: Panicle 0\.0\.1 in the folder, Panicle \d\S* now/,
		);
		written.set("d/series.json", "{");
		expect((await series(words, written)).messages[0]).toContain("series.json in the folder cannot be read");
	});

	it("takes the same series in other words", async () => {
		const { written } = await series(["--seeds", "1-3"]);
		const { status, messages } = await series(["--seeds", "1,2,3"], written);
		expect([status, messages]).toEqual([0, ["3 plants: 0 grown, 3 already there; d/plants.csv"]]);
	});
});

describe("a folder without a manifest", () => {
	it.each(["plants.csv", "plants.csv.part", "plants-1-of-2.csv", "redcurrant-2.json"])(
		"that has %s is left as it is",
		async (name) => {
			const written: Written = new Map([[`d/${name}`, "mine"]]);
			const { status, messages } = await series(["--seeds", "1-3"], written);
			expect([status, [...written]]).toEqual([2, [[`d/${name}`, "mine"]]]);
			expect(messages).toEqual([
				`grow: --out d: ${name} exists, but the folder has no series.json to describe its series. Choose another folder.`,
			]);
		},
	);

	it("that has other files is used", async () => {
		const written: Written = new Map([
			["d/redcurrant-9.json", "mine"],
			["d/notes.txt", "mine"],
		]);
		expect((await series(["--seeds", "1-3"], written)).status).toBe(0);
		expect(written.get("d/redcurrant-9.json")).toBe("mine");
	});
});

describe("the lock of a table", () => {
	const words = ["--seeds", "1-2"];
	const owner = { host: "here", process: 7, token: "theirs", at: 1_000_000 };

	it.each([
		["whose process has ended", owner, { isRunning: () => false }],
		["of a machine that was last heard of six minutes ago", { ...owner, host: "there", at: 1_000_000 - 360_000 }, {}],
		["of a number that another process has now", { ...owner, at: 1_000_000 - 360_000 }, {}],
		["of one's own number, as in a container", owner, { process: 7 }],
	])("%s blocks no other process", async (_, lock, differs) => {
		const written: Written = new Map([[LOCK, JSON.stringify(lock)]]);
		expect((await series(words, written, differs)).status).toBe(0);
		expect(written.has(LOCK)).toBe(false);
	});

	it("that was half written blocks no other process", async () => {
		expect((await series(words, new Map([[LOCK, '{"host":']]))).status).toBe(0);
	});

	it.each([
		["of a process that runs", owner],
		["of another machine that was heard of a minute ago", { ...owner, host: "there", at: 940_000 }],
	])("%s holds others up", async (_, lock) => {
		const written: Written = new Map([[LOCK, JSON.stringify(lock)]]);
		const { status, messages } = await series(words, written);
		expect(status).toBe(2);
		expect(messages[0]).toMatch(
			/Process 7 on t?here is writing this table \(last active \d+ s ago\)\. Wait until it has finished\.$/,
		);
		expect(JSON.parse(textOf(written, LOCK))).toEqual(lock);
		expect(written.has(`${TABLE}.part`)).toBe(false);
	});

	it("is renewed while plants grow", async () => {
		let time = 1_000_000;
		const written: Written = new Map();
		const signs: number[] = [];
		await series(["--seeds", "1-4"], written, {
			now: () => {
				if (written.has(LOCK)) signs.push(JSON.parse(textOf(written, LOCK)).at);
				time += 15_000;
				return time;
			},
		});
		expect(new Set(signs).size).toBeGreaterThan(2);
	});

	it("that another process has taken ends this one before it writes", async () => {
		const written: Written = new Map();
		const { world, messages } = memoryWorld({}, {}, written);
		const theirs = JSON.stringify(owner);
		const loadCore: CommandEnvironment["loadCore"] = (wasm) => {
			written.set(LOCK, theirs);
			return world.loadCore(wasm);
		};
		expect(await run([...SMALL, ...words], { ...world, loadCore })).toBe(1);
		expect(messages).toEqual(["grow: Another process has taken over d/plants.csv.lock, so this one stops."]);
		expect([...written.keys()].filter((path) => path.includes("redcurrant"))).toEqual([]);
		expect(written.get(LOCK)).toBe(theirs);
	});

	it("is released when the process receives a signal to end", async () => {
		const written: Written = new Map();
		let onSignal: (() => Promise<void>) | undefined;
		const { world } = memoryWorld({}, {}, written);
		const loadCore: CommandEnvironment["loadCore"] = async (wasm) => {
			expect(written.has(LOCK)).toBe(true);
			await onSignal?.();
			expect(written.has(LOCK)).toBe(false);
			return world.loadCore(wasm);
		};
		const whenTerminated: CommandEnvironment["whenTerminated"] = (work) => {
			onSignal = work;
			return () => {};
		};
		await run([...SMALL, ...words], { ...world, loadCore, whenTerminated });
		expect(onSignal).toBeDefined();
	});
});

describe("what cannot be written", () => {
	const failing = (code: string, pattern: RegExp, written: Written) => {
		const { world } = memoryWorld({}, {}, written);
		const replaceFile: CommandEnvironment["replaceFile"] = async (path, data) => {
			if (pattern.test(path)) throw Object.assign(new Error(`${code}: write`), { code });
			await world.replaceFile(path, data);
		};
		return { replaceFile };
	};

	it("since the disk is full ends with 1, and the series goes on where it was", async () => {
		const written: Written = new Map();
		const { status, messages } = await series(["--seeds", "1-4"], written, failing("ENOSPC", /redcurrant-3/, written));
		expect([status, messages]).toEqual([1, ["grow: d/redcurrant-3.json could not be written. The disk is full."]]);
		expect(written.has(LOCK)).toBe(false);
		expect((await series(["--seeds", "1-4"], written)).messages).toEqual([
			"4 plants: 2 grown, 2 already there; d/plants.csv",
		]);
	});

	it("since the call names what is not allowed ends with 2", async () => {
		const written: Written = new Map();
		const { status, messages } = await series(["--seeds", "1-2"], written, failing("EACCES", /\.part$/, written));
		expect([status, messages]).toEqual([2, ["grow: --out d/plants.csv.part: Access is not allowed."]]);
	});
});
