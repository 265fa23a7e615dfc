/** Series of plants: draws, folders, tables, files of several kinds, and labels of points. */
const FOLDER = ["tests/web/cli/series_folder.test.ts"];
const LABELS = ["tests/web/formats/ply_labels.test.ts"];

export default [
	{
		file: "web/src/cli/time_limit.ts",
		suites: ["tests/web/cli/seconds.test.ts"],
		faults: [
			{
				id: "seconds-part-of-a-plant-in-a-series",
				find: 'if (plant.cutShort === "time") throw this.#timeOverError();',
				replace: "",
				breaks: "a series with a time limit writes a part of a plant as if it were whole, and never grows it again",
			},
		],
	},
	{
		file: "web/src/cli/run.ts",
		suites: ["tests/web/cli/seconds.test.ts"],
		faults: [
			{
				id: "cut-short-status-of-a-whole-plant",
				find: "if (cutShort) return cutShort ===",
				replace: "if (cutShort && missed) return cutShort ===",
				breaks: "scripts take a plant that was cut short for a whole one",
			},
		],
	},
	{
		file: "web/src/batch/draws.ts",
		suites: ["tests/web/batch/draws.test.ts"],
		faults: [
			{
				id: "draws-seeds-counted-up",
				find: 'seed: (number) => draw("seed", number),',
				replace: "seed: (number) => number,",
				breaks: "lengths of a series are spread evenly, and the same in every variety",
			},
			{
				id: "draws-alike-in-every-series",
				find: "const draw = hashFunction(specificationOf(schema, from));",
				replace: 'const draw = hashFunction("");',
				breaks: "plants of one number have the same values in every variety and setting",
			},
			{
				id: "draws-one-quantity-for-all",
				find: "hashText([specification, quantity].join",
				replace: "hashText([specification].join",
				breaks: "two parameters that are varied rise and fall together",
			},
			{
				id: "draws-not-mixed-twice",
				find: "return mixBits(mixBits(number ^ key[0]) ^ key[1]);",
				replace: "return (number * 0x9e3779b9 + key[0]) >>> 0;",
				breaks: "values of a series are spread evenly, not at random",
			},
		],
	},
	{
		file: "web/src/batch/manifest.ts",
		suites: FOLDER,
		faults: [
			{
				id: "manifest-forgets-the-numbers",
				find: "plants: formatRanges(numbers),",
				replace: 'plants: "",',
				breaks: "a series of fewer plants cuts the table of a longer one",
			},
			{
				id: "manifest-forgets-the-settings",
				find: "settings: { v, ...others },",
				replace: "settings: { v },",
				breaks: "a series with another --set overwrites the files of the first",
			},
		],
	},
	{
		file: "web/src/cli/series.ts",
		suites: FOLDER,
		faults: [
			{
				id: "series-overwrites-what-is-there",
				find: "if (taken !== undefined) {",
				replace: "if (taken === MANIFEST) {",
				breaks: "a series overwrites files that are none of its own",
			},
			{
				id: "series-writes-without-its-lock",
				find: "const plant = await grower.grow(member);\n\t\t\tawait lock.renew();",
				replace: "const plant = await grower.grow(member);",
				breaks: "two processes write one table after one of them was silent for long",
			},
			{
				id: "series-one-file-of-several",
				find: "for (const { name, bytes, sum } of files) {",
				replace: "for (const { name, bytes, sum } of files.slice(0, 1)) {",
				suites: ["tests/web/cli/series.test.ts"],
				breaks: "a file that is missing beside others is not made again",
			},
		],
	},
	{
		file: "web/src/cli/table_lock.ts",
		suites: FOLDER,
		faults: [
			{
				id: "lock-of-the-dead-holds",
				find: "return host !== world.host || (process !== world.process && world.isRunning(process));",
				replace: "return true;",
				breaks: "a series that was interrupted is refused for five minutes",
			},
			{
				id: "lock-for-ever",
				find: "if (!(Math.abs(world.now() - at) < EXPIRY)) return false;",
				replace: "",
				breaks: "a lock of a machine that has crashed blocks its table until someone deletes it",
			},
		],
	},
	{
		file: "web/src/cli/writing.ts",
		suites: FOLDER,
		faults: [
			{
				id: "writing-blames-the-call",
				find: "if (Object.hasOwn(OF_THE_PATH, code))",
				replace: "if (code)",
				breaks: "a full disk is said to be a mistake in the call",
			},
		],
	},
	{
		file: "web/src/cli/node_files.ts",
		suites: ["tests/web/cli/node_files.test.ts"],
		faults: [
			{
				id: "files-created-over-each-other",
				find: "await link(unfinished, path);",
				replace: "await writeFile(path, data);",
				breaks: "two series that begin together both believe that the folder is theirs",
			},
		],
	},
	{
		file: "web/src/formats/ply.ts",
		suites: LABELS,
		faults: [
			{
				id: "ply-points-that-are-hidden",
				find: "if (!isHidden(cover, candidates.at(i))) visible[visibleCount++] = i;",
				replace: "visible[visibleCount++] = i;",
				breaks: "points where berries touch are of either, by chance",
			},
		],
	},
	{
		file: "web/src/models/bunch/parts/point_labels.ts",
		suites: LABELS,
		faults: [
			{
				id: "labels-berries-by-index",
				find: 'typeof extras?.id === "number" ? extras.id :',
				replace: "extras === undefined ? 0 :",
				breaks: "berry_id is another number than the JSON's id",
			},
		],
	},
	{
		file: "web/src/formats/classes.ts",
		suites: ["tests/web/formats/json.test.ts"],
		faults: [
			{
				id: "classes-without-the-look",
				find: "[...measured, ...looks].flatMap(",
				replace: "[...measured, ...looks.slice(9)].flatMap(",
				breaks: "the class of the skin's colour (OIV 225) is not in the JSON",
			},
		],
	},
];
