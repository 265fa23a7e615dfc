/** Targets for measures, from the search to the page and the command line. */
const SRC = "web/src/targets";

export default [
	{
		file: `${SRC}/search.ts`,
		suites: ["tests/web/targets/search.test.ts"],
		faults: [
			{
				id: "search-beyond-its-bounds",
				find: "return Math.min(Math.max(value, from), to);",
				replace: "return from <= to ? value : from;",
				breaks: "what is asked for takes parameters beyond their limits",
			},
			{
				id: "search-learns-nothing",
				find: "if (length < SHORTEST_STEP * SHORTEST_STEP) return;",
				replace: "if (length >= 0) return;",
				breaks: "a search goes on with the slopes it began with, and takes many growths more",
			},
		],
	},
	{
		file: `${SRC}/solve.ts`,
		suites: ["tests/web/targets/solve.test.ts"],
		faults: [
			{
				id: "solve-one-lever-alone",
				find: "if (further.length === 0) break;",
				replace: "break;",
				breaks: "a bunch grows no longer than its pixels allow, though its scale could go on",
			},
			{
				id: "solve-one-value-of-a-range",
				find: "const isReached = isAimReached(task, values) || isWithin(task, values);",
				replace: "const isReached = isAimReached(task, values);",
				breaks: "a target of a range is missed though the plant measures within it",
			},
			{
				id: "solve-spent-unsaid",
				find: "isAtLimit: !isReached && atLimit.includes(i)",
				replace: "isAtLimit: false",
				breaks: "nothing says that a number is out of reach",
			},
		],
	},
	{
		file: "web/src/models/bunch/levers.ts",
		suites: ["tests/web/models/bunch/levers.test.ts"],
		faults: [
			{
				id: "levers-widths-with-the-length",
				find: "return [key, keys.includes(key) ? factor * pixels : pixels];",
				replace: "return [key, keys.includes(key) ? factor * pixels : parameters[key]];",
				breaks: "a bunch that is asked to be longer than its pixels becomes wider too",
			},
		],
	},
	{
		file: "web/src/app/target_search.ts",
		suites: ["tests/web/app/target_search.test.ts"],
		faults: [
			{
				id: "asking-forgets-what-it-holds",
				find: "sameSpecimen(found.specimen, studio.state.specimen) ? found.aims : []",
				replace: "sameSpecimen(found.specimen, studio.state.specimen) ? [] : []",
				breaks: "a second number that is asked for undoes the first",
			},
			{
				id: "asking-against-the-hand",
				find: "if (studio.state.model !== model || !growsAlike(studio.state.specimen, from)) cancel();",
				replace: "if (studio.state.model !== model) cancel();",
				breaks: "what was asked for overrules what a hand does meanwhile",
			},
		],
	},
	{
		file: "web/src/batch/table.ts",
		suites: ["tests/web/cli/targets.test.ts"],
		faults: [
			{
				id: "series-asked-grown-again",
				find: 'const link = cells.get("from") ?? cell("link");',
				replace: 'const link = cell("link");',
				breaks: "a series with a target grows all its plants again when it is taken up",
			},
		],
	},
	{
		file: "web/src/specimen/lengths.ts",
		suites: ["tests/web/specimen/lengths.test.ts"],
		faults: [
			{
				id: "lengths-in-their-own-unit",
				find: "if (per === undefined) return",
				replace: "if (per !== 0) return",
				breaks: "lengths stand in pixels of the paper, which say nothing to who measures bunches",
			},
		],
	},
	{
		file: "web/src/specimen/history.ts",
		suites: ["tests/web/specimen/history.test.ts"],
		faults: [
			{
				id: "history-a-step-a-press",
				find: "if (run !== undefined && run === settled.run)",
				replace: "if (run !== undefined && run !== run)",
				breaks: "ten presses of an arrow key are ten steps to undo",
			},
		],
	},
	{
		file: "web/src/specimen/restore.ts",
		suites: ["tests/web/specimen/restore.test.ts"],
		faults: [
			{
				id: "restore-assumes-in-silence",
				find: "if (since > 1)",
				replace: "if (since > 9)",
				breaks: "a link without a version shows a variety otherwise than the page does, without a word",
			},
		],
	},
	{
		file: "web/src/models/bunch/photo/photo.ts",
		suites: ["tests/web/models/bunch/profile/photo.test.ts"],
		faults: [
			{
				id: "photo-scales-away",
				find: "x: fixedPoint.x + appliedFactor * (x - fixedPoint.x),\n\t\ty: fixedPoint.y + appliedFactor * (y - fixedPoint.y),",
				replace: "x,\n\t\ty,",
				breaks: "a photograph runs away from the pointer that scales it",
			},
		],
	},
];
